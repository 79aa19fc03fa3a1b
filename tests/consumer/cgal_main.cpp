#include <CGAL/Exact_rational.h>

#include <iostream>
#include <plumbline/cgal.hpp>
#include <type_traits>

// Plumbline's numbers are CGAL's.
static_assert(std::is_same_v<plumbline::Rational, CGAL::Exact_rational>);

int main() {
  using plumbline::cgal::Kernel;
  const plumbline::Rational third = plumbline::parse_decimal("1/3");
  const Kernel::Point_2 p{Kernel::FT(third), Kernel::FT(third)};
  std::cout << p << '\n';
  return CGAL::exact(p).x() == third ? 0 : 1;
}
