#include "drivers/commands/study_templates.hpp"

namespace anisofront {
namespace {

constexpr const char* kLayer =
    R"toml(# Thin layers of -div(a grad u) + c u = f on a square, isotropic against anisotropic.
# Lines that begin with "#" are comments; those with "# key = ..." show what else can be said.
title = "Reaction and diffusion: boundary layers"

# Curves with names, and regions bounded by them.
# Other curves: { polyline = [[0, 0], [1, 0], [1, 1]] }, { spline = [[0, 0], [1, 0.2], [2, 0]] },
# { circle = { centre = [0.5, 0.5], radius = 0.2 } }, { ellipse = { centre, radii, rotation } },
# { arc = { centre, radius, start, end } } in degrees. A hole: holes = [["hole"]] beside boundary.
[domain]
curves.bottom = { line = [[0, 0], [1, 0]] }
curves.right = { line = [[1, 0], [1, 1]] }
curves.top = { line = [[1, 1], [0, 1]] }
curves.left = { line = [[0, 1], [0, 0]] }
regions.square = { boundary = ["bottom", "right", "top", "left"] }

[mesh]
initial_size = 0.1                  # edges of the first mesh, which may be coarse
# elements = "quadrilateral"        # of the meshes from cycle 1 on; or "mixed"

# Numbers, or expressions of the constants, x and y: + - * / ^, sqrt, exp, log, sin, cos, abs, pi.
[problem]
kind = "poisson"                    # or "mindlin": anisofront new floor --kind plate
order = 1                           # of the elements; or 2
constants = { eps = 0.01 }          # names for numbers
diffusion = "eps^2"                 # a
reaction = 1                        # c
source = 1                          # f
# velocity = [1, 0]                 # b of + b grad u
boundary.bottom = { value = 0 }     # u = 0
boundary.right = { value = 0 }      # or { flux = 1 }: a du/dn = 1
boundary.top = { value = 0 }        # or { robin = { transfer = 2, flux = 0 } }: a du/dn + 2 u = 0
boundary.left = { value = 0 }       # without a condition: a du/dn = 0

# Each cycle solves, estimates the error and makes the next mesh, whose elements share it evenly.
[adapt]
cycles = 5
target = { nodes = 1000 }           # vertices of the meshes; or { error = 0.02 }, in energy
# limits = { hmin = 1e-4, stretch = 100 }  # smallest size, largest ratio of the two sizes
# budget = { nodes = 50000, seconds = 60 } # where to stop at the latest
reference = { nodes = 5000 }        # true errors, against one finer solution

[output]
values = [{ name = "centre", at = [0.5, 0.5] }]
lines = [{ name = "across-the-layer", from = [0.9, 0.5], to = [1, 0.5], points = 101 }]
# formats = ["msh", "vtu"]          # for Gmsh, for ParaView

# Variants: every combination of the entries below, here named alternatives of several keys.
# One of them alone: --set vary.mesh=fine
[vary.mesh]
coarse = { adapt = { mode = "anisotropic", target.nodes = 200 } }
fine = { adapt = { mode = "anisotropic", target.nodes = 1000 } }
isotropic = { adapt = { mode = "isotropic", target.nodes = 2500 } }

# [vary]
# "problem.order" = [1, 2]          # a list of values is an entry too
)toml";

constexpr const char* kPlate =
    R"toml(# A simply supported Reissner-Mindlin plate under uniform load, with thin layers along its edges.
# Lines that begin with "#" are comments; those with "# key = ..." show what else can be said.
title = "Square plate on soft supports"

# Any consistent units: here m, N and Pa.
# Other curves: { polyline = [[0, 0], [1, 0], [1, 1]] }, { spline = [[0, 0], [1, 0.2], [2, 0]] },
# { circle = { centre = [0.5, 0.5], radius = 0.2 } }, { ellipse = { centre, radii, rotation } },
# { arc = { centre, radius, start, end } } in degrees. A hole: holes = [["hole"]] beside boundary.
[domain]
curves.south = { line = [[0, 0], [4, 0]] }
curves.east = { line = [[4, 0], [4, 4]] }
curves.north = { line = [[4, 4], [0, 4]] }
curves.west = { line = [[0, 4], [0, 0]] }
regions.slab = { boundary = ["south", "east", "north", "west"] }

[mesh]
initial_size = 0.5                  # edges of the first mesh, which may be coarse
# elements = "quadrilateral"        # of the meshes from cycle 1 on; or "mixed"

# Numbers, or expressions such as "5e3*(1 + x)".
[problem]
kind = "mindlin"
thickness = 0.1
young = 30e9
poisson_ratio = 0.2
load = 5e3                          # pressure along the deflection w
# regions.slab = { thickness = 0.2 }  # what is different in one region
boundary.south = "soft-support"     # w = 0
boundary.east = "soft-support"      # or "hard-support": w = 0 and no rotation along the edge
boundary.north = "soft-support"     # or "clamped", "symmetry", "antisymmetry"
boundary.west = "soft-support"      # or "free"; { support = "free", shear = 2e3 }: an edge load
# points = [{ at = [2, 2], force = 1e4 }]  # at the nearest vertex

# Each cycle solves, estimates the error and makes the next mesh, whose elements share it evenly.
# Limits and layers follow from thickness and supports.
[adapt]
cycles = 5
target = { nodes = 600 }            # vertices of the meshes; or { error = 0.02 }, in energy
# mode = "isotropic"                # for comparison
# goal = { kind = "patch-mean", at = [2, 2], radius = 0.2 }  # to be exact, not the energy

[output]
values = [{ name = "centre", at = [2, 2] }]
lines = [{ name = "south-edge", curve = "south", points = 101 }]
# formats = ["msh", "vtu"]          # for Gmsh, for ParaView

# Every combination of the values below is one variant of the study.
# [vary]
# "problem.thickness" = [0.2, 0.1, 0.05]
# "adapt.mode" = ["isotropic", "anisotropic"]
)toml";

constexpr const char* kPaper =
    R"toml(# Example 2 of the paper: nothing is solved, formulas prescribe the sizes of the elements.
# Lines that begin with "#" are comments; those with "# key = ..." show what else can be said.
title = "Example 2: square with two layers"

[domain]
curves.bottom = { line = [[0, 0], [10, 0]] }
curves.right = { line = [[10, 0], [10, 10]] }
curves.top = { line = [[10, 10], [0, 10]] }
curves.left = { line = [[0, 10], [0, 0]] }
regions.square = { boundary = ["bottom", "right", "top", "left"] }

[mesh]
initial_size = 2.5                  # of the first mesh; or initial = "coarse.msh"
# elements = "quadrilateral"        # or "mixed"
# preset = "paper"                  # every stage as published; see [vary] below

# Sizes: h1 along the direction e1, h2 across. Where entries overlap, the smaller size wins.
# Expressions know x, y and the names of `where`; with distance_to = ["left"] also d, the distance
# to that curve, tx and ty, its tangent, and c, its curvature.
[metric]
where = { along_y = "0.05 + 0.2*y^1.25", along_x = "0.05 + 0.2*x^1.25" }
prescribed = [
  { h1 = "8*h2*exp(-0.2079*y)", h2 = "along_y", e1 = ["1", "0"] },
  { h1 = "along_x", h2 = "8*h1*exp(-0.2079*x)", e1 = ["1", "0"] },
]
# Along a curve: { h1 = "0.01 + 0.2*d", h2 = "0.5", e1 = ["-ty", "tx"], distance_to = ["left"] }

[adapt]
cycles = 5
# limits = { gradation = 1.5 }      # largest ratio of sizes over a unit length

[output]
formats = ["msh", "svg"]            # for Gmsh, and a picture of every mesh; or "vtu", "mesh"

[report]
paper = { triangle = "13d", quadrilateral = "13e" }  # rows of its tables, beside ours

# Every combination of the values below is one variant of the study.
[vary]
"mesh.preset" = ["best", "paper"]
# "mesh.elements" = ["triangle", "quadrilateral"]
)toml";

constexpr const char* kMesh =
    R"toml(# Heat conduction in a wall with a pipe. The domain is that of a Gmsh mesh, whose physical groups
# give the names below.
# Lines that begin with "#" are comments; those with "# key = ..." show what else can be said.
title = "Heat in a wall with a pipe"

# The mesh gives the boundary, and the cycles start from it. Your own .msh (2.2 or 4.1) may stand
# here: its curves and surfaces need physical groups, the curves with names.
[domain]
mesh = @MESH@
boundary = "smooth"                 # curves through the vertices; or "linear": straight edges
corner_angle = 40                   # boundary vertices that turn by more degrees are corners

# Numbers, or expressions of x and y: + - * / ^, sqrt, exp, log, sin, cos, abs, pi.
[problem]
kind = "poisson"                    # -div(a grad u) + c u = f; or "mindlin": plates
order = 2                           # of the elements; or 1
diffusion = 0.8                     # a: W/(m K)
# reaction = 0                      # c
# source = 0                        # f
# regions.wall = { diffusion = 2 }  # what is different in one region
boundary.inner = { robin = { transfer = 8, flux = "8*20" } }  # a du/dn + 8 u = 8 * 20 degrees
boundary.outer = { robin = { transfer = 25, flux = "25*-5" } }
boundary.pipe = { value = 60 }      # u = 60 degrees
# boundary.top = { flux = 0 }       # a du/dn = 0, also where nothing is said

# Each cycle solves, estimates the error and makes the next mesh, whose elements share it evenly.
[adapt]
cycles = 5
target = { error = 1e-3 }           # relative, in energy; or { nodes = 1000 }: vertices
# mode = "isotropic"                # for comparison
# goal = { kind = "flux", curve = "pipe" } # to be exact, not the energy

[output]
values = [{ name = "middle", at = [0.5, 0.5] }]
lines = [{ name = "through-the-wall", from = [0, 0.5], to = [1.2, 0.5], points = 101 }]
# formats = ["msh", "vtu"]          # for Gmsh, for ParaView

# Every combination of the values below is one variant of the study.
# [vary]
# "problem.order" = [1, 2]
# "adapt.mode" = ["isotropic", "anisotropic"]
)toml";

constexpr const char* kMeshSource = R"toml(title = "mesh to start from"
[domain]
curves.inner = { line = [[0, 0], [0, 1]] }
curves.top = { line = [[0, 1], [2, 1]] }
curves.outer = { line = [[2, 1], [2, 0]] }
curves.bottom = { line = [[2, 0], [0, 0]] }
curves.pipe = { circle = { centre = [1.4, 0.5], radius = 0.2 } }
regions.wall = { boundary = ["inner", "top", "outer", "bottom"], holes = [["pipe"]] }
[mesh]
initial_size = 0.15
[metric]
prescribed = [{ h1 = "1", h2 = "1" }]
)toml";

}  // namespace

const std::vector<StudyTemplate>& study_templates() {
  static const std::vector<StudyTemplate> kTemplates{
      {"layer", "reaction and diffusion, isotropic against anisotropic", kLayer, ""},
      {"plate", "a plate on supports", kPlate, ""},
      {"paper", "Example 2 of the paper, sizes by formula", kPaper, ""},
      {"mesh", "heat in the domain of a Gmsh mesh, which is written too", kMesh, kMeshSource}};
  return kTemplates;
}

}  // namespace anisofront
