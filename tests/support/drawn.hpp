#pragma once

#include <rapidjson/document.h>

#include <catch2/catch.hpp>
#include <pugixml.hpp>
#include <string>

#include "segments.hpp"

/// Two rooms, a hole in one, a dangling edge.
inline const std::string kRooms =
    rectangle(0, 0, 8, 8) + "0 4 8 4  " + rectangle(1, 1, 2, 2) + "8 8 9 9";

inline rapidjson::Document parsed(const std::string& json) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseFullPrecisionFlag>(json.c_str());
  REQUIRE(!document.HasParseError());
  return document;
}

inline std::string text(const rapidjson::Value& value) { return value.GetString(); }

inline std::size_t count(const std::string& svg, const char* xpath) {
  pugi::xml_document document;
  REQUIRE(document.load_string(svg.c_str()));
  return document.select_nodes(xpath).size();
}

/// The area of triangles.
inline double area(const std::vector<std::array<plumbline::PointD, 3>>& triangles) {
  double doubled = 0;
  for (const auto& [p, q, r] : triangles) {
    doubled += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }
  return doubled / 2;
}
