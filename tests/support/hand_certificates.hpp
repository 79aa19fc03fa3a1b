#pragma once

#include <map>
#include <string>

#include "certificates/text.hpp"

/// Certificates written by hand from docs/certificate.md.
namespace hand_certificates {

struct Case {
  std::string input;
  std::string certificate;
};

/// The sections of a certificate with its title, signature and end.
inline std::string complete(const std::string& sections) {
  return plumbline::certificates::with_signature("plumbline certificate 1\nsignature 0\n" +
                                                 sections + "end\n");
}

inline const std::map<std::string, Case>& cases() {
  static const std::map<std::string, Case> all = [] {
    std::map<std::string, Case> result;
    const auto add = [&](const char* name, const char* input, const char* sections) {
      result[name] = {input, complete(sections)};
    };
    add("nothing", "",
        "vertices 0\n"
        "edges 0\n"
        "cycles 0\n"
        "faces 1\n"
        "outer - depth 0 parent - holes isolated inside -\n"
        "components 0\n");
    add("a segment from right to left", "2,3,0,1\n",
        "vertices 2\n"
        "0 1 end 0 1\n"
        "2 3 end 0 0\n"
        "edges 1\n"
        "0 1 0:0\n"
        "cycles 1\n"
        "+0 -0\n"
        "faces 1\n"
        "outer - depth 0 parent - holes 0 isolated inside -\n"
        "components 1\n"
        "0 0\n");
    add("a crossing", "0,0,1,1\n0,0.5,1,0\n",
        "vertices 5\n"
        "0 0 end 0 0\n"
        "0 1/2 end 1 0\n"
        "1/3 1/3 cross 0 1\n"
        "1 0 end 1 1\n"
        "1 1 end 0 1\n"
        "edges 4\n"
        "0 2 0:0\n"
        "1 2 1:0\n"
        "2 3 1:1\n"
        "2 4 0:1\n"
        "cycles 1\n"
        "+0 -1 +1 +3 -3 +2 -2 -0\n"
        "faces 1\n"
        "outer - depth 0 parent - holes 0 isolated inside -\n"
        "components 1\n"
        "0 0\n");
    add("an overlap and a duplicate", "0,0,2,0\n3,0,1,0\n0,0,2,0\n",
        "vertices 4\n"
        "0 0 end 0 0\n"
        "1 0 end 1 1\n"
        "2 0 end 0 1\n"
        "3 0 end 1 0\n"
        "edges 3\n"
        "0 1 0:0 2:0\n"
        "1 2 0:1 1:0 2:1\n"
        "2 3 1:1\n"
        "cycles 1\n"
        "+0 +1 +2 -2 -1 -0\n"
        "faces 1\n"
        "outer - depth 0 parent - holes 0 isolated inside -\n"
        "components 1\n"
        "0 0\n");
    add("a T-junction", "0,0,2,0\n1,0,1,1\n",
        "vertices 4\n"
        "0 0 end 0 0\n"
        "1 0 end 1 0\n"
        "1 1 end 1 1\n"
        "2 0 end 0 1\n"
        "edges 3\n"
        "0 1 0:0\n"
        "1 2 1:0\n"
        "1 3 0:1\n"
        "cycles 1\n"
        "+0 +1 -1 +2 -2 -0\n"
        "faces 1\n"
        "outer - depth 0 parent - holes 0 isolated inside -\n"
        "components 1\n"
        "0 0\n");
    add("a pencil through a point", "-1,0,1,0\n-1,-1,1,1\n0,-1,0,1\n",
        "vertices 7\n"
        "-1 -1 end 1 0\n"
        "-1 0 end 0 0\n"
        "0 -1 end 2 0\n"
        "0 0 cross 0 1\n"
        "0 1 end 2 1\n"
        "1 0 end 0 1\n"
        "1 1 end 1 1\n"
        "edges 6\n"
        "0 3 1:0\n"
        "1 3 0:0\n"
        "2 3 2:0\n"
        "3 4 2:1\n"
        "3 5 0:1\n"
        "3 6 1:1\n"
        "cycles 1\n"
        "+0 -1 +1 +3 -3 +5 -5 +4 -4 -2 +2 -0\n"
        "faces 1\n"
        "outer - depth 0 parent - holes 0 isolated inside -\n"
        "components 1\n"
        "0 0\n");
    add("a triangle in a square that touches its corner",
        "0,0,4,0\n4,0,4,4\n4,4,0,4\n0,4,0,0\n0,0,2,1\n2,1,1,2\n1,2,0,0\n",
        "vertices 6\n"
        "0 0 end 0 0\n"
        "0 4 end 2 1\n"
        "1 2 end 5 1\n"
        "2 1 end 4 1\n"
        "4 0 end 0 1\n"
        "4 4 end 1 1\n"
        "edges 7\n"
        "0 1 3:0\n"
        "0 2 6:0\n"
        "0 3 4:0\n"
        "0 4 0:0\n"
        "1 5 2:0\n"
        "2 3 5:0\n"
        "4 5 1:0\n"
        "cycles 3\n"
        "+0 +4 -6 -3\n"
        "-0 +1 +5 -2 +3 +6 -4\n"
        "-1 +2 -5\n"
        "faces 3\n"
        "outer - depth 0 parent - holes 0 isolated inside -\n"
        "outer 1 depth 1 parent 0 holes isolated inside 2 3\n"
        "outer 2 depth 1 parent 0 holes isolated inside 5/8 1/2\n"
        "components 1\n"
        "0 0\n");
    add("an antenna and a point in a face", "0,0,4,0\n4,0,4,4\n4,4,0,4\n0,4,0,0\n0,0,1,1\n2,3\n",
        "vertices 6\n"
        "0 0 end 0 0\n"
        "0 4 end 2 1\n"
        "1 1 end 4 1\n"
        "2 3 point 0\n"
        "4 0 end 0 1\n"
        "4 4 end 1 1\n"
        "edges 5\n"
        "0 1 3:0\n"
        "0 2 4:0\n"
        "0 4 0:0\n"
        "1 5 2:0\n"
        "4 5 1:0\n"
        "cycles 2\n"
        "+0 +3 -4 -2\n"
        "-0 +1 -1 +2 +4 -3\n"
        "faces 2\n"
        "outer - depth 0 parent - holes 0 isolated inside -\n"
        "outer 1 depth 1 parent 0 holes isolated 3 inside 2 2\n"
        "components 2\n"
        "0 0\n"
        "3 1\n");
    add("a square in a square, points in both, a segment beside them",
        "0,0,8,0\n8,0,8,8\n8,8,0,8\n0,8,0,0\n2,2,6,2\n6,2,6,6\n6,6,2,6\n2,6,2,2\n9,0,9,5\n"
        "4,4\n1,1\n",
        "vertices 12\n"
        "0 0 end 0 0\n"
        "0 8 end 2 1\n"
        "1 1 point 1\n"
        "2 2 end 4 0\n"
        "2 6 end 6 1\n"
        "4 4 point 0\n"
        "6 2 end 4 1\n"
        "6 6 end 5 1\n"
        "8 0 end 0 1\n"
        "8 8 end 1 1\n"
        "9 0 end 8 0\n"
        "9 5 end 8 1\n"
        "edges 9\n"
        "0 1 3:0\n"
        "0 8 0:0\n"
        "1 9 2:0\n"
        "3 4 7:0\n"
        "3 6 4:0\n"
        "4 7 6:0\n"
        "6 7 5:0\n"
        "8 9 1:0\n"
        "10 11 8:0\n"
        "cycles 5\n"
        "+0 +2 -7 -1\n"
        "-0 +1 +7 -2\n"
        "+3 +5 -6 -4\n"
        "-3 +4 +6 -5\n"
        "+8 -8\n"
        "faces 3\n"
        "outer - depth 0 parent - holes 0 4 isolated inside -\n"
        "outer 1 depth 1 parent 0 holes 2 isolated 2 inside 1 4\n"
        "outer 3 depth 2 parent 1 holes isolated 5 inside 4 3\n"
        "components 5\n"
        "0 0\n"
        "2 1\n"
        "3 1\n"
        "5 2\n"
        "10 0\n");
    add("two parallel segments", "0,0,4,0\n0,1,4,1\n",
        "vertices 4\n"
        "0 0 end 0 0\n"
        "0 1 end 1 0\n"
        "4 0 end 0 1\n"
        "4 1 end 1 1\n"
        "edges 2\n"
        "0 2 0:0\n"
        "1 3 1:0\n"
        "cycles 2\n"
        "+0 -0\n"
        "+1 -1\n"
        "faces 1\n"
        "outer - depth 0 parent - holes 0 1 isolated inside -\n"
        "components 2\n"
        "0 0\n"
        "1 0\n");
    add("vertical segments that overlap, crossed", "0,0,0,3\n0,1,0,4\n-1,2,1,2\n",
        "vertices 7\n"
        "-1 2 end 2 0\n"
        "0 0 end 0 0\n"
        "0 1 end 1 0\n"
        "0 2 cross 0 2\n"
        "0 3 end 0 1\n"
        "0 4 end 1 1\n"
        "1 2 end 2 1\n"
        "edges 6\n"
        "0 3 2:0\n"
        "1 2 0:0\n"
        "2 3 0:1 1:0\n"
        "3 4 0:2 1:1\n"
        "3 6 2:1\n"
        "4 5 1:2\n"
        "cycles 1\n"
        "+0 +3 +5 -5 -3 +4 -4 -2 -1 +1 +2 -0\n"
        "faces 1\n"
        "outer - depth 0 parent - holes 0 isolated inside -\n"
        "components 1\n"
        "0 0\n");
    add("points on a segment and beside it, a row without length",
        "1,1,1,1\n0,0,1,0\n5,5\n1,0\n1/2,0\n",
        "vertices 4\n"
        "0 0 end 0 0\n"
        "1/2 0 point 2\n"
        "1 0 end 0 1\n"
        "5 5 point 0\n"
        "edges 2\n"
        "0 1 0:0\n"
        "1 2 0:1\n"
        "cycles 1\n"
        "+0 +1 -1 -0\n"
        "faces 1\n"
        "outer - depth 0 parent - holes 0 isolated 3 inside -\n"
        "components 2\n"
        "0 0\n"
        "3 0\n");
    return result;
  }();
  return all;
}

}  // namespace hand_certificates
