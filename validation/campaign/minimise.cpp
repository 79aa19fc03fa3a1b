#include "campaign/minimise.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "plumbline/error.hpp"

namespace plumbline::campaign {

namespace {

/// Segments first, then points; an item is a row of coordinates.
using Row = std::vector<Rational>;

std::vector<Row> rows_of(const SegmentSet& input) {
  std::vector<Row> result;
  for (const Segment& s : input.segments) result.push_back({s.a.x, s.a.y, s.b.x, s.b.y});
  for (const Point& p : input.points) result.push_back({p.x, p.y});
  return result;
}

SegmentSet set_of(const std::vector<Row>& all) {
  SegmentSet set;
  const SourceId source = set.add_source({});
  for (const Row& row : all) {
    if (row.size() == 4) {
      set.add({{row[0], row[1]}, {row[2], row[3]}}, source);
    } else {
      set.add_point({row[0], row[1]}, source);
    }
  }
  return set;
}

std::vector<Row> with_fewer_rows(std::vector<Row> all, const Fails& fails) {
  for (std::size_t count = std::max<std::size_t>(all.size() / 2, 1); count > 0;) {
    bool shrunk = false;
    for (std::size_t first = 0; first < all.size();) {
      std::vector<Row> rest(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(first));
      const std::size_t end = std::min(all.size(), first + count);
      rest.insert(rest.end(), all.begin() + static_cast<std::ptrdiff_t>(end), all.end());
      if (fails(set_of(rest))) {
        all = std::move(rest);
        shrunk = true;
      } else {
        first += count;
      }
    }
    if (!shrunk || count > 1) count /= 2;
  }
  return all;
}

/// Numbers with a shorter text come first; of those the smaller ones.
bool is_simpler(const Rational& a, const Rational& b) {
  const std::size_t la = a.get_str().size(), lb = b.get_str().size();
  return la != lb ? la < lb : cmp(abs(a), abs(b)) < 0;
}

/// Simpler numbers, the simplest first: small integers, the value rounded to fewer and fewer
/// places, its continued fraction cut off.
std::vector<Rational> simpler(const Rational& value) {
  std::vector<Rational> result{0, 1, -1, 2, -2, 3, -3, value / 2, value / 10};
  mpz_class whole;
  for (const int scale : {1, 2, 3, 10, 1000, 1'000'000, 1'000'000'000}) {
    const Rational scaled = value * scale;
    mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
    for (const int more : {0, 1}) result.push_back(Rational(whole + more) / scale);
  }
  for (Rational rest = value, p0 = 1, q0 = 0, p1 = 0, q1 = 1;;) {
    mpz_fdiv_q(whole.get_mpz_t(), rest.get_num_mpz_t(), rest.get_den_mpz_t());
    const Rational p = Rational(whole) * p0 + p1, q = Rational(whole) * q0 + q1;
    if (q != 0) result.push_back(p / q);
    if (rest == Rational(whole)) break;
    rest = 1 / (rest - Rational(whole));
    p1 = std::exchange(p0, p);
    q1 = std::exchange(q0, q);
  }
  std::erase_if(result, [&](const Rational& r) { return !is_simpler(r, value); });
  std::sort(result.begin(), result.end(), is_simpler);
  return result;
}

/// Moves of everything that may make numbers smaller.
std::vector<std::vector<Row>> simpler_as_a_whole(const std::vector<Row>& all) {
  std::vector<std::vector<Row>> result;
  for (const std::size_t i : {0U, 1U}) {
    std::vector<Row> moved = all;
    for (Row& row : moved) {
      for (std::size_t k = i; k < row.size(); k += 2) row[k] -= all[0][i];
    }
    result.push_back(moved);
  }
  for (const int factor : {2, 3, 7, 1000}) {
    for (const bool up : {false, true}) {
      std::vector<Row> scaled = all;
      for (Row& row : scaled) {
        for (Rational& x : row) x = up ? Rational(x * factor) : Rational(x / factor);
      }
      result.push_back(scaled);
    }
  }
  return result;
}

std::size_t length(const std::vector<Row>& all) {
  std::size_t sum = 0;
  for (const Row& row : all) {
    for (const Rational& x : row) sum += x.get_str().size();
  }
  return sum;
}

/// One number replaced everywhere, or in one row only, by a simpler one; whether that is done.
bool replace_one(std::vector<Row>& all, const Fails& fails) {
  std::set<Rational> values;
  for (const Row& row : all) values.insert(row.begin(), row.end());
  for (const Rational& value : values) {
    for (const Rational& simple : simpler(value)) {
      std::vector<Row> changed = all;
      for (Row& row : changed) std::replace(row.begin(), row.end(), value, simple);
      if (!fails(set_of(changed))) continue;
      all = std::move(changed);
      return true;
    }
  }
  for (std::size_t r = 0; r < all.size(); ++r) {
    for (std::size_t k = 0; k < all[r].size(); ++k) {
      for (const Rational& simple : simpler(all[r][k])) {
        std::vector<Row> changed = all;
        changed[r][k] = simple;
        if (!fails(set_of(changed))) continue;
        all = std::move(changed);
        return true;
      }
    }
  }
  return false;
}

std::vector<Row> with_simpler_numbers(std::vector<Row> all, const Fails& fails) {
  for (bool again = true; again && !all.empty();) {
    again = false;
    for (std::vector<Row>& candidate : simpler_as_a_whole(all)) {
      if (length(candidate) < length(all) && fails(set_of(candidate))) {
        all = std::move(candidate);
        again = true;
        break;
      }
    }
    again = again || replace_one(all, fails);
  }
  return all;
}

}  // namespace

SegmentSet minimised(const SegmentSet& input, const Fails& fails) {
  std::vector<Row> all = with_fewer_rows(rows_of(input), fails);
  all = with_simpler_numbers(std::move(all), fails);
  return set_of(with_fewer_rows(std::move(all), fails));
}

SegmentSet from_rows(const std::string& text) {
  std::istringstream lines(text);
  std::vector<Row> all;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    std::istringstream fields(line);
    Row row;
    for (std::string field; std::getline(fields, field, ',');) row.push_back(parse_decimal(field));
    if (row.size() != 2 && row.size() != 4) {
      throw Error(ErrorCode::BadInput, "a row has two numbers or four", {}, line);
    }
    all.push_back(std::move(row));
  }
  return set_of(all);
}

}  // namespace plumbline::campaign
