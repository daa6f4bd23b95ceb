#pragma once

#include "drivers/history/history_json.hpp"
#include "tests/drivers/temporary_folder.hpp"

namespace anisofront::testing {

/// A variant with cycles 0, 1, ... of which only the numbers are filled in.
inline VariantHistory plain_variant(const std::string& name, int cycles) {
  VariantHistory variant;
  variant.name = name;
  variant.settings = {{"adapt.mode", "isotropic"}};
  variant.stop_reason = "finished";
  for (int k = 0; k < cycles; ++k) {
    CycleRecord record;
    record.cycle = k;
    record.background.vertices = k + 1;
    variant.cycles.push_back(record);
  }
  return variant;
}

}  // namespace anisofront::testing
