#!/bin/sh
# Makes the .msh files of this folder with gmsh 4.8.4 (Debian 12).
set -e
for flavour in "22.ascii -format msh22" "22.binary -format msh22 -bin" \
               "41.ascii -format msh41" "41.binary -format msh41 -bin"; do
  set -- $flavour; name=$1; shift
  gmsh -2 two-squares.geo "$@" -o two-squares.$name.msh
  gmsh -2 disc.geo -order 2 "$@" -o second-order.$name.msh
done
gmsh -2 disc.geo -setnumber Mesh.RecombineAll 1 -format msh22 -bin -o quads.22.binary.msh
gmsh -2 disc.geo -setnumber Mesh.RecombineAll 1 -format msh41 -o quads.41.ascii.msh
gmsh -2 disc.geo -setnumber Mesh.RecombineAll 1 -order 2 -format msh41 -bin -o quads-9.41.binary.msh
gmsh -2 disc.geo -setnumber Mesh.RecombineAll 1 -order 2 -setnumber Mesh.SecondOrderIncomplete 1 -format msh22 -o quads-8.22.ascii.msh
gmsh -2 two-squares.geo -part 2 -format msh41 -o partitioned.41.ascii.msh
gmsh -2 two-squares.geo -part 2 -format msh41 -bin -o partitioned.41.binary.msh
gmsh -2 two-squares.geo -part 2 -format msh22 -o partitioned.22.ascii.msh
gmsh - views.geo
