#pragma once

#include <string>
#include <vector>

#include "mesher/io/gmsh.hpp"
#include "mesher/metric/metric_field.hpp"

namespace anisofront {

/// A mesh with its fields for the viewer of the page (page/mesh_decode.js reads it): few bytes
/// rather than all digits. `metric`: what the mesh was made for, or empty when that is unknown.
/// `note`: what readers are told about the mesh.
///
/// Little-endian u32 length of the header, the header (JSON, padded with spaces to a multiple of
/// 4 bytes), then the arrays in the order of header.arrays. Header:
///   vertices, triangles, quads, edges: counts; centre: [x, y] of the bounding box;
///   regions, curves: names by tag; note, if there is one;
///   arrays: {name, on, count (of all codes), components (else 1), planes (bytes per code, else 1),
///            after (else "nothing"), scale (else "linear"), step (else 1)}
/// An array is a sequence of integer codes, one component after the other, as byte_planes() of
/// their residuals: `after` "neighbours" (in the order of mesh_walk()) or "previous", or as they
/// are, `after` "nothing". `scale` "linear" or "log2": see CodeScale.
///
/// corner-recent, corner-far: the vertices of all elements, triangles first. A code of
///   corner-recent is 0 for one more than the highest vertex so far, k = 1 ... 127 for the k-th
///   latest one of those seen, and -1 for the next entry of corner-far.
/// point-exponent, point (2 components): coordinates relative to the centre, in units of
///   2^exponent, at most 2^-11 of the shortest edge at the vertex (2^-28 of the mesh).
/// curve-edge (2 vertices), curve-tag; region (tag per element, where there are several).
/// metric (xx, xy, yy): log2 of the sizes, as the tensor log2(M^(-1/2)), to 2^-9;
/// quality: of the elements in it, to 2^-11; edge-length: along mesh_edges() in it, as mesh
///   statistics count it, to 0.6 %, the bounds of the unit band lying between two codes.
/// Fields of the file, scalars under their name, "|NAME|" of vectors, "moments xx" and so on of
/// moments and other symmetric tensors; see scale_for(). NaN stays NaN.
///
/// Precondition: a mesh with vertex numbers in range and finite points. Same input, same bytes.
/// They come in blocks of one kind, as gzip() likes them.
std::vector<std::string> mesh_blob(const MeshFile& file, const MetricFunction& metric,
                                   const std::string& note = {});

}  // namespace anisofront
