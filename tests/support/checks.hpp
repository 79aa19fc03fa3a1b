#pragma once

#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "segments.hpp"

namespace plumbline {

/// A quadrangle with a side of 1/100, and the triangle that is left when the side collapses.
struct Example {
  SegmentSet input = segments("0 0 4 0  4 0 4 0.01  4 0.01 0 4  0 4 0 0");
  ExactComplex exact_complex = arrange(input);
  FloatComplex float_complex = nearest(arrange(segments("0 0 4 0  4 0 0 4  0 4 0 0")));
  Comparison comparison = plumbline::compare(exact_complex, float_complex, 0.125);

  Check checked() const {
    Check result;
    result.input = input;
    result.exact_complex = exact_complex;
    result.answer.complex = float_complex;
    result.answer.engine = "lar";
    result.answer.title = result.answer.short_title = "float LAR";
    result.answer.radius = 0.0625;
    result.comparison = comparison;
    result.groups = group_findings(comparison, {}, exact_complex, float_complex);
    result.conversion = plumbline::compare(exact_complex, exact_complex, 0);
    return result;
  }
};

/// A drawing held against its own nearest doubles.
struct Agreement {
  SegmentSet input;
  ExactComplex exact_complex = arrange(input);
  FloatComplex float_complex = nearest(exact_complex);
  Comparison comparison = plumbline::compare(exact_complex, float_complex, 0.125);

  Check checked() const {
    Check result;
    result.input = input;
    result.exact_complex = exact_complex;
    result.answer.complex = float_complex;
    result.answer.engine = "lar";
    result.answer.title = result.answer.short_title = "float LAR";
    result.answer.radius = 0.0625;
    result.comparison = comparison;
    result.groups = group_findings(comparison, {}, exact_complex, float_complex);
    result.conversion = plumbline::compare(exact_complex, exact_complex, 0);
    return result;
  }
};

}  // namespace plumbline
