// The module plumbline._core.

#include "core.hpp"

#include <string>

namespace plumbline::python {

nb::object int_of(const mpz_class& value) {
  if (value.fits_slong_p()) return nb::steal(PyLong_FromLong(value.get_si()));
  return nb::steal(PyLong_FromString(value.get_str(16).c_str(), nullptr, 16));
}

namespace {
/// fractions.Fraction: kept for as long as the program runs, since what is static would outlive
/// Python. Set while the module is loaded, so that no thread waits for an import.
nb::object* fraction = nullptr;
}  // namespace

nb::object fraction_of(const Rational& value) {
  if (value.get_den() == 1) return (*fraction)(int_of(value.get_num()));
  return (*fraction)(int_of(value.get_num()), int_of(value.get_den()));
}

std::function<bool(double)> Progress::callback() {
  return [this](double part) {
    const nb::gil_scoped_acquire acquire;
    try {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      if (!progress_.is_none()) progress_(part);
      return true;
    } catch (const nb::python_error&) {
      raised_ = std::current_exception();
      return false;
    }
  };
}

}  // namespace plumbline::python

namespace nanobind::detail {

bool type_caster<plumbline::Rational>::from_python(handle source, std::uint8_t,
                                                   cleanup_list*) noexcept {
  try {
    Py_ssize_t size = 0;
    const char* text =
        PyUnicode_Check(source.ptr()) ? PyUnicode_AsUTF8AndSize(source.ptr(), &size) : nullptr;
    if (text == nullptr) {
      PyErr_Clear();
      return false;
    }
    value = plumbline::parse_decimal({text, static_cast<std::size_t>(size)});
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

bool type_caster<plumbline::Point>::from_python(handle source, std::uint8_t flags,
                                                cleanup_list* cleanup) noexcept {
  make_caster<plumbline::Rational> x, y;
  if (!isinstance<nanobind::tuple>(source) || len(source) != 2) return false;
  if (!x.from_python(source[0], flags, cleanup) || !y.from_python(source[1], flags, cleanup)) {
    return false;
  }
  value = {x.value, y.value};
  return true;
}

bool type_caster<plumbline::PointD>::from_python(handle source, std::uint8_t flags,
                                                 cleanup_list* cleanup) noexcept {
  make_caster<double> x, y;
  if (!isinstance<nanobind::tuple>(source) || len(source) != 2) return false;
  if (!x.from_python(source[0], flags, cleanup) || !y.from_python(source[1], flags, cleanup)) {
    return false;
  }
  value = {x.value, y.value};
  return true;
}

}  // namespace nanobind::detail

NB_MODULE(_core, m) {
  using namespace plumbline::python;
  m.doc() = "Bindings of the C++ library; the package `plumbline` is made of them.";
  fraction = new nb::object(nb::module_::import_("fractions").attr("Fraction"));
  m.attr("VERSION") = PLUMBLINE_VERSION;
  bind_error(m);
  bind_geometry(m);
  bind_affine(m);
  bind_model(m);
  bind_structure(m);
  bind_read(m);
  bind_complex(m);
  bind_arrange(m);
  bind_polygons(m);
  bind_round(m);
  bind_triangulate(m);
  bind_features(m);
  bind_output(m);
  bind_compare(m);
  bind_engine(m);
  bind_programs(m);
  bind_check(m);
  bind_minimise(m);
  bind_certificate(m);
  bind_ladder(m);
  bind_diagnose(m);
  bind_rings(m);
  bind_rooms(m);
  bind_edits(m);
  bind_repair(m);
  bind_regions(m);
  bind_coverage(m);
  bind_validity(m);
  bind_lar(m);
}
