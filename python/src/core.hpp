#pragma once

// What all bindings share: how numbers, points and indices cross, arrays without copies, work that
// Ctrl-C ends.

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <functional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "plumbline/complex.hpp"

namespace plumbline::python {

namespace nb = nanobind;

/// One for each public header, in a source of its name.
void bind_error(nb::module_& m);
void bind_geometry(nb::module_& m);
void bind_state(nb::class_<SegmentSet>& type);  ///< pickling
void bind_affine(nb::module_& m);
void bind_model(nb::module_& m);
void bind_structure(nb::module_& m);
void bind_lar(nb::module_& m);
void bind_read(nb::module_& m);
void bind_complex(nb::module_& m);
void bind_arrange(nb::module_& m);
void bind_polygons(nb::module_& m);
void bind_round(nb::module_& m);
void bind_triangulate(nb::module_& m);
void bind_features(nb::module_& m);
void bind_output(nb::module_& m);
void bind_compare(nb::module_& m);
void bind_engine(nb::module_& m);
void bind_programs(nb::module_& m);
void bind_check(nb::module_& m);
void bind_minimise(nb::module_& m);
void bind_certificate(nb::module_& m);  ///< with the checker
void bind_ladder(nb::module_& m);
void bind_diagnose(nb::module_& m);
void bind_rings(nb::module_& m);
void bind_rooms(nb::module_& m);
void bind_edits(nb::module_& m);
void bind_repair(nb::module_& m);
void bind_regions(nb::module_& m);  ///< with overlays
void bind_coverage(nb::module_& m);
void bind_validity(nb::module_& m);

/// A Python int, however large.
nb::object int_of(const mpz_class& value);
/// A fractions.Fraction.
nb::object fraction_of(const Rational& value);

/// NumPy arrays as the stub calls them.
class DoubleArray : public nb::object {
  NB_OBJECT(DoubleArray, nb::object, "numpy.typing.NDArray[numpy.float64]", is_array)
 private:
  static bool is_array(PyObject*) { return true; }
};
class IndexArray : public nb::object {
  NB_OBJECT(IndexArray, nb::object, "numpy.typing.NDArray[numpy.uint32]", is_array)
 private:
  static bool is_array(PyObject*) { return true; }
};
class IntArray : public nb::object {
  NB_OBJECT(IntArray, nb::object, "numpy.typing.NDArray[numpy.int64]", is_array)
 private:
  static bool is_array(PyObject*) { return true; }
};
template <class T>
using ArrayOf = std::conditional_t<
    std::is_same_v<T, double>, DoubleArray,
    std::conditional_t<std::is_same_v<T, std::uint32_t>, IndexArray,
                       std::conditional_t<std::is_same_v<T, std::int64_t>, IntArray, nb::object>>>;
/// Lists as SciPy and Arrow have them: (indptr, indices).
using ListArrays = nb::typed<nb::tuple, IndexArray, IndexArray>;

/// A read-only array of the memory that `owner` keeps: no copy. Rows of `width` numbers; one
/// dimension for a width of 0.
template <class T>
ArrayOf<T> view(const T* data, std::size_t count, std::size_t width, nb::handle owner) {
  const std::size_t shape[2] = {count, width};
  return nb::steal<ArrayOf<T>>(
      nb::cast(nb::ndarray<nb::numpy, const T>(data, width == 0 ? 1 : 2, shape, owner),
               nb::rv_policy::reference)
          .release());
}
/// The same of memory that goes over to Python.
template <class T>
ArrayOf<T> array(std::vector<T> values, std::size_t width = 0) {
  auto* kept = new std::vector<T>(std::move(values));
  const nb::capsule owner(kept, [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
  return view(kept->data(), kept->size() / (width == 0 ? 1 : width), width, owner);
}

/// Indices as the numbers that they are.
template <class Tag>
const std::uint32_t* numbers(const std::vector<Index<Tag>>& indices) {
  static_assert(sizeof(Index<Tag>) == sizeof(std::uint32_t));
  return reinterpret_cast<const std::uint32_t*>(indices.data());
}
template <class Tag>
IndexArray view(const std::vector<Index<Tag>>& indices, nb::handle owner) {
  return view(numbers(indices), indices.size(), 0, owner);
}
template <class T>
ListArrays view(const Lists<T>& lists, nb::handle owner) {
  static_assert(sizeof(T) == sizeof(std::uint32_t));
  const auto starts = lists.starts();
  return nb::borrow<ListArrays>(
      nb::make_tuple(view(starts.data(), starts.size(), 0, owner),
                     view(reinterpret_cast<const std::uint32_t*>(lists.flat().data()),
                          lists.flat().size(), 0, owner)));
}
template <class T>
ListArrays arrays(Lists<T> lists) {
  auto* kept = new Lists<T>(std::move(lists));
  const nb::capsule owner(kept, [](void* p) noexcept { delete static_cast<Lists<T>*>(p); });
  return view(*kept, owner);
}

/// Defines == by that of C++; another type is another value.
template <class T>
void define_equality(nb::class_<T>& type) {
  type.def(
      "__eq__", [](const T& a, const T& b) { return a == b; }, nb::is_operator(),
      nb::sig("def __eq__(self, other: object, /) -> bool"));
}

/// A callback for long work, which runs without the GIL: it takes it, looks for Ctrl-C, and tells
/// `progress`, which may be None, the part that is done. What Python raised is raised again by
/// `rethrow`.
class Progress {
 public:
  explicit Progress(nb::object progress) : progress_(std::move(progress)) {}
  std::function<bool(double)> callback();
  /// Does the work without the GIL. Throws what Python raised in between, else what the work
  /// throws.
  template <class Work>
  auto run(const Work& work) {
    try {
      const nb::gil_scoped_release release;
      return work(callback());
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Cancelled && raised_) std::rethrow_exception(raised_);
      throw;
    }
  }

 private:
  nb::object progress_;
  std::exception_ptr raised_;
};

}  // namespace plumbline::python

namespace nanobind::detail {

/// Out as Fraction; in as its text, which the package makes of all that is a number.
template <>
struct type_caster<plumbline::Rational> {
  NB_TYPE_CASTER(plumbline::Rational, io_name("str", "fractions.Fraction"))
  bool from_python(handle source, std::uint8_t flags, cleanup_list* cleanup) noexcept;
  static handle from_cpp(const plumbline::Rational& value, rv_policy, cleanup_list*) {
    return plumbline::python::fraction_of(value).release();
  }
};

template <>
struct type_caster<plumbline::Point> {
  NB_TYPE_CASTER(plumbline::Point,
                 io_name("tuple[str, str]", "tuple[fractions.Fraction, fractions.Fraction]"))
  bool from_python(handle source, std::uint8_t flags, cleanup_list* cleanup) noexcept;
  static handle from_cpp(const plumbline::Point& p, rv_policy, cleanup_list*) {
    return make_tuple(plumbline::python::fraction_of(p.x), plumbline::python::fraction_of(p.y))
        .release();
  }
};

template <>
struct type_caster<plumbline::PointD> {
  NB_TYPE_CASTER(plumbline::PointD, const_name("tuple[float, float]"))
  bool from_python(handle source, std::uint8_t flags, cleanup_list* cleanup) noexcept;
  static handle from_cpp(const plumbline::PointD& p, rv_policy, cleanup_list*) {
    return make_tuple(p.x, p.y).release();
  }
};

/// An index as an int; None where it is none.
template <class Tag>
struct type_caster<plumbline::Index<Tag>> {
  NB_TYPE_CASTER(plumbline::Index<Tag>, io_name("int", "int | None"))
  bool from_python(handle source, std::uint8_t flags, cleanup_list* cleanup) noexcept {
    make_caster<std::uint32_t> number;
    if (!number.from_python(source, flags, cleanup)) return false;
    value = plumbline::Index<Tag>(number.value);
    return true;
  }
  static handle from_cpp(plumbline::Index<Tag> i, rv_policy, cleanup_list*) {
    return i.valid() ? PyLong_FromSize_t(i) : none().release().ptr();
  }
};

/// Lists of indices as lists of ints: those in lists are always there.
template <class Tag>
struct type_caster<std::vector<plumbline::Index<Tag>>> {
  using Value_ = std::vector<plumbline::Index<Tag>>;
  NB_TYPE_CASTER(Value_, const_name("list[int]"))
  bool from_python(handle source, std::uint8_t flags, cleanup_list* cleanup) noexcept {
    make_caster<std::vector<std::uint32_t>> indices;
    if (!indices.from_python(source, flags, cleanup)) return false;
    value.clear();
    for (const std::uint32_t i : indices.value) value.emplace_back(i);
    return true;
  }
  static handle from_cpp(const Value_& indices, rv_policy, cleanup_list*) {
    list result;
    for (const std::size_t i : indices) result.append(i);
    return result.release();
  }
};

}  // namespace nanobind::detail
