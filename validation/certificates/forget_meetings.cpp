#include "certificates/forget_meetings.hpp"

#include <map>
#include <numeric>

#include "certificates/fields.hpp"

namespace plumbline::certificates {
namespace {

struct Edge {
  std::size_t tail, head;
  std::vector<std::size_t> segments;
  std::size_t old_number;
};

std::vector<Edge> edges_of(Fields& fields) {
  std::vector<Edge> edges;
  for (std::size_t e = 0; e < fields.count("edges"); ++e) {
    const Line& line = fields.item("edges", e);
    edges.push_back({std::stoul(line[0]), std::stoul(line[1]), {}, e});
    for (std::size_t i = 2; i < line.size(); ++i) {
      edges.back().segments.push_back(std::stoul(line[i]));
    }
  }
  return edges;
}

/// Joins each edge that ends at a vertex with the one that goes on along the same segments.
void run_on(std::vector<Edge>& edges, std::size_t vertex) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto goes_on = [&](const Edge& other) {
      return other.tail == vertex && other.segments == edges[e].segments;
    };
    if (edges[e].head != vertex) continue;
    const auto next = std::find_if(edges.begin(), edges.end(), goes_on);
    if (next == edges.end()) continue;
    edges[e].head = next->head;
    if (next < edges.begin() + static_cast<std::ptrdiff_t>(e)) --e;
    edges.erase(next);
  }
}

constexpr std::size_t kGone = static_cast<std::size_t>(-1);

void put_edges(Fields& fields, const std::vector<Edge>& edges,
               const std::vector<std::size_t>& vertices) {
  std::map<std::size_t, std::size_t> pieces;  // of each segment so far
  std::vector<Line> lines;
  for (const Edge& edge : edges) {
    lines.push_back({std::to_string(vertices[edge.tail]), std::to_string(vertices[edge.head])});
    for (const std::size_t s : edge.segments) {
      lines.back().push_back(std::to_string(s) + ":" + std::to_string(pieces[s]++));
    }
  }
  fields.replace("edges", lines);
}

void put_cycles(Fields& fields, const std::vector<std::size_t>& edges) {
  for (std::size_t c = 0; c < fields.count("cycles"); ++c) {
    Line kept;
    for (const std::string& h : fields.item("cycles", c)) {
      const std::size_t edge = edges[std::stoul(h.substr(1))];
      if (edge != kGone) kept.push_back(h.substr(0, 1) + std::to_string(edge));
    }
    fields.item("cycles", c) = kept.empty() ? Line{"+0"} : kept;
  }
}

/// Vertices in the lists of isolated ones and of components.
void put_references(Fields& fields, const std::vector<std::size_t>& vertices) {
  const auto renumber = [&](std::string& field) {
    const std::size_t v = vertices[std::stoul(field)];
    field = std::to_string(v == kGone ? 0 : v);
  };
  for (std::size_t f = 0; f < fields.count("faces"); ++f) {
    Line& face = fields.item("faces", f);
    const auto end = std::find(face.begin(), face.end(), "inside");
    std::for_each(std::find(face.begin(), end, "isolated") + 1, end, renumber);
  }
  for (std::size_t c = 0; c < fields.count("components"); ++c) {
    renumber(fields.item("components", c)[0]);
  }
}

}  // namespace

void forget_meetings(Fields& fields, Random& random) {
  const std::size_t count = fields.count("vertices");
  if (count == 0) return;
  std::vector<Edge> edges = edges_of(fields);
  std::vector<char> had_edges(count, 0), has_edges(count, 0);
  for (const Edge& edge : edges) had_edges[edge.tail] = had_edges[edge.head] = 1;
  const bool one = below(random, 2) == 0;
  const std::size_t which = below(random, count);
  for (std::size_t v = 0; v < count; ++v) {
    if (one ? v == which : below(random, 2) == 0) run_on(edges, v);
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::pair(a.tail, a.head) < std::pair(b.tail, b.head);
  });
  for (const Edge& edge : edges) has_edges[edge.tail] = has_edges[edge.head] = 1;

  std::vector<std::size_t> vertices(count, kGone);
  std::vector<Line> lines;
  for (std::size_t v = 0; v < count; ++v) {
    const Line& line = fields.item("vertices", v);
    if (line[2] == "cross" && had_edges[v] != 0 && has_edges[v] == 0) continue;
    vertices[v] = lines.size();
    lines.push_back(line);
  }
  std::vector<std::size_t> new_edges(fields.count("edges"), kGone);
  for (std::size_t e = 0; e < edges.size(); ++e) new_edges[edges[e].old_number] = e;
  put_cycles(fields, new_edges);
  put_references(fields, vertices);
  put_edges(fields, edges, vertices);
  fields.replace("vertices", lines);
}

}  // namespace plumbline::certificates
