// overlay_plumbline FILE [THREADS]: segments in, exact polygons with holes, areas and sources out.

#include "plumbline/arrange.hpp"
#include "plumbline/regions.hpp"
#include "workload.hpp"

using namespace plumbline;

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const workload::Workload given = workload::read(argv[1]);
  SegmentSet input;
  std::vector<Region> regions;
  for (const auto& rings : given.sets) {
    Region region{regions.empty() ? "A" : "B",
                  given.rule == "nonzero" ? FillRule::NonZero : FillRule::EvenOdd,
                  {}};
    const SourceId source = input.add_source({});
    for (const workload::Ring& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto [ax, ay] = ring[i];
        const auto [bx, by] = ring[(i + 1) % ring.size()];
        region.segments.emplace_back(input.segments.size());
        input.add(NumberPoint{Number(ax), Number(ay)}, NumberPoint{Number(bx), Number(by)}, source);
      }
    }
    regions.push_back(std::move(region));
  }
  ArrangeOptions options;
  options.threads = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  workload::Measure measure;
  const ExactComplex complex = arrange(input, ExactEngine::Bucket, options);
  const LabelledComplex labelled = label(input, complex, std::move(regions));
  const FaceSet faces = select(labelled, given.operation == "xor" ? "A ^ B" : "A & B");
  const RegionPolygons result = region_polygons(complex, faces);
  measure.end();
  Rational area = 0;
  for (const Rational& part : result.areas) area += part;
  measure.print(result.polygons.size(), nearest_double(area));
}
