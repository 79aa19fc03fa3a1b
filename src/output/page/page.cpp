// The report as one page that needs nothing but itself.

#include "output/page/page.hpp"

#include "output/page/arrays.hpp"
#include "output/page/assets.hpp"
#include "output/text/escape.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kFindingsWithoutScript = 1000;

// The page loads nothing from anywhere, whatever names the drawing holds.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: "
    "blob:; base-uri 'none'; form-action 'none'";

std::string title(const Check& check) {
  const std::string file = check.input.files.empty() ? "drawing" : check.input.files[0];
  return file + ": " + verdict(check);
}

}  // namespace

std::string page_with_data(const std::string& title, const std::string& style,
                           std::string_view body, const std::string& without_script,
                           const PageData& data, std::string_view script) {
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  page += "<meta http-equiv=\"Content-Security-Policy\" content=\"";
  page += kPolicy;
  page += "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  page += "<meta name=\"color-scheme\" content=\"light dark\">\n<title>";
  page += xml_text(title);
  page += "</title>\n<style>\n";
  page += style;
  page += "</style>\n</head>\n<body>\n";
  page += body;
  page += "<noscript><pre>\n";
  page += xml_text(without_script);
  page += "</pre></noscript>\n<script type=\"text/plain\" id=\"report\">";
  page += packed(data.json);
  page += "</script>\n<script type=\"text/plain\" id=\"arrays\">";
  page += packed(data.arrays);
  page += "</script>\n<script>\n";
  page += script;
  page += "</script>\n</body>\n</html>\n";
  return page;
}

std::string to_html(const Check& check) {
  return page_with_data(title(check), std::string(kPageStyle), kPageBody,
                        to_text(check, kFindingsWithoutScript), page_data(check), kPageScript);
}

}  // namespace plumbline
