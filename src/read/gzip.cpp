#include "read/gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

/// zlib's state while inflating.
class Inflater {
 public:
  Inflater() {
    constexpr int kGzipOnly = 16;
    ensure(inflateInit2(&stream_, MAX_WBITS + kGzipOnly) == Z_OK, "zlib starts");
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream& stream() { return stream_; }

 private:
  z_stream stream_{};
};

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1F\x8B"); }

std::string inflated(std::string_view bytes, const std::string& file, std::size_t max_size) {
  std::string text;
  std::array<char, std::size_t{1} << 16U> part;
  Inflater inflater;
  z_stream& stream = inflater.stream();
  while (true) {
    if (stream.avail_in == 0) {
      const std::size_t count =
          std::min<std::size_t>(bytes.size(), std::numeric_limits<uInt>::max());
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
      stream.avail_in = static_cast<uInt>(count);
      bytes.remove_prefix(count);
    }
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    const int status = inflate(&stream, Z_NO_FLUSH);
    text.append(part.data(), part.size() - stream.avail_out);
    if (text.size() > max_size) {
      throw Error(ErrorCode::Limit, "inflates to more than " + std::to_string(max_size) + " bytes",
                  {file, 0, 0});
    }
    if (status == Z_STREAM_END) {
      if (stream.avail_in == 0 && bytes.empty()) return text;
      ensure(inflateReset(&stream) == Z_OK, "zlib starts again");  // another member follows
    } else if (status != Z_OK) {
      const bool is_cut = status == Z_BUF_ERROR;
      throw Error(ErrorCode::BadInput,
                  std::string("malformed gzip: ") +
                      (is_cut || stream.msg == nullptr ? "ends too early" : stream.msg),
                  {file, 0, 0});
    }
  }
}

}  // namespace plumbline
