#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesher/quads/quadrangulate.hpp"

namespace anisofront {

/// A value and the word that stands for it in study files and on the command line.
template <class Value>
struct Named {
  const char* name;
  Value value;
};

inline constexpr std::array<Named<Elements>, 3> kElementNames{
    {{"triangle", Elements::triangle},
     {"quadrilateral", Elements::quadrilateral},
     {"mixed", Elements::mixed}}};
inline constexpr std::array<Named<QuadMethod>, 2> kQuadMethodNames{
    {{"best", QuadMethod::best}, {"paper", QuadMethod::paper}}};
inline constexpr std::array<Named<QuadEffort>, 2> kQuadEffortNames{
    {{"best", QuadEffort::best}, {"fast", QuadEffort::fast}}};
inline constexpr std::array<Named<QuadStart>, 5> kQuadStartNames{
    {{"automatic", QuadStart::automatic},
     {"right-angle", QuadStart::right_angle},
     {"equilateral", QuadStart::equilateral},
     {"greedy", QuadStart::greedy},
     {"systematic", QuadStart::systematic}}};

template <class Value, std::size_t N>
std::vector<std::string> names_of(const std::array<Named<Value>, N>& table) {
  std::vector<std::string> names;
  for (const Named<Value>& entry : table) names.emplace_back(entry.name);
  return names;
}

/// The value of a word; the first one of the table for a word that is not in it.
template <class Value, std::size_t N>
Value value_named(const std::array<Named<Value>, N>& table, const std::string& name) {
  for (const Named<Value>& entry : table)
    if (name == entry.name) return entry.value;
  return table.front().value;
}

/// The word of a value. Precondition: the table holds the value.
template <class Value, std::size_t N>
const char* name_of(const std::array<Named<Value>, N>& table, Value value) {
  for (const Named<Value>& entry : table)
    if (value == entry.value) return entry.name;
  return "";
}

}  // namespace anisofront
