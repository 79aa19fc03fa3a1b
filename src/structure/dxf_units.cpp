#include "structure/dxf_units.hpp"

#include <array>

namespace plumbline {
namespace {

struct NamedUnit {
  const char* name;
  const char* metres;
};

/// By the codes of $INSUNITS, from 1.
constexpr std::array kUnits{
    NamedUnit{"in", "254/10000"},
    NamedUnit{"ft", "3048/10000"},
    NamedUnit{"mi", "1609344/1000"},
    NamedUnit{"mm", "1/1000"},
    NamedUnit{"cm", "1/100"},
    NamedUnit{"m", "1"},
    NamedUnit{"km", "1000"},
    NamedUnit{"microinch", "254/10000000000"},
    NamedUnit{"mil", "254/10000000"},
    NamedUnit{"yd", "9144/10000"},
    NamedUnit{"angstrom", "1/10000000000"},
    NamedUnit{"nm", "1/1000000000"},
    NamedUnit{"um", "1/1000000"},
    NamedUnit{"dm", "1/10"},
    NamedUnit{"dam", "10"},
    NamedUnit{"hm", "100"},
    NamedUnit{"Gm", "1000000000"},
    NamedUnit{"au", "149597870700"},
    NamedUnit{"light year", "9460730472580800"},
    NamedUnit{"parsec", "30856775814913673"},
    NamedUnit{"US survey ft", "1200/3937"},
    NamedUnit{"US survey in", "100/3937"},
    NamedUnit{"US survey yd", "3600/3937"},
    NamedUnit{"US survey mi", "6336000/3937"},
};

}  // namespace

std::optional<LengthUnit> unit_of_code(std::int64_t code) {
  if (code < 1 || code > std::int64_t{kUnits.size()}) return {};
  const NamedUnit& unit = kUnits.at(static_cast<std::size_t>(code) - 1);
  Rational metres(unit.metres);
  metres.canonicalize();
  return LengthUnit{unit.name, metres};
}

std::int64_t code_of_unit(const Rational& metres) {
  for (std::int64_t code = 1; const auto unit = unit_of_code(code); ++code) {
    if (unit->metres == metres) return code;
  }
  return 0;
}

}  // namespace plumbline
