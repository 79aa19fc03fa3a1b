// Errors become exceptions of plumbline.errors.

#include "plumbline/error.hpp"

#include "core.hpp"

namespace plumbline::python {
namespace {

const char* class_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::BadFile:
      return "FileError";
    case ErrorCode::Limit:
      return "LimitError";
    case ErrorCode::Internal:
      return "InternalError";
    case ErrorCode::BadInput:
    case ErrorCode::Cancelled:
      break;
  }
  return "Error";
}

void raise(const Error& error) {
  try {
    const nb::object type = nb::module_::import_("plumbline.errors").attr(class_of(error.code()));
    const Place& place = error.place();
    const nb::object exception = type(valid_utf8(error.what()), valid_utf8(place.file), place.line,
                                      place.column, valid_utf8(error.offending_text()));
    PyErr_SetObject(type.ptr(), exception.ptr());
  } catch (nb::python_error& e) {
    e.restore();
  }
}

}  // namespace

void bind_error(nb::module_&) {
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(error);
    }
  });
}

}  // namespace plumbline::python
