#include <catch.hpp>

#include "program.hpp"

/// Drives that no model here has.
namespace swayaw {
namespace {

using test::refusal;
using test::Scratch;

TEST_CASE("a ship file that names an azimuth drive is refused by name before anything is done", "[app][refusal]") {
  const Scratch scratch;
  const auto file = (scratch / "pod.toml").string();
  const auto text = read_text(test::ships / "kvlcc2_l7.toml");
  const auto with_table = text + "\n[azimuth]\ncount = 2\n";
  write_text(scratch / "pod.toml", with_table);
  for (const auto& words :
       {"simulate " + file + " --zigzag 10/10", "identify run.csv --ship " + file + " --model mmg --out x.toml",
        "diagnose " + file + " run.csv"})
    CHECK_THAT(refusal(words), ContainsSubstring("\"azimuth\" steers by turning its thrust"));
  write_text(scratch / "pod.toml", "name = \"Azimuth\"\nmodel = \"linear\"\n[rudder]\nkind = \"Z-drive\"\n");
  CHECK_THAT(refusal("indices " + file), ContainsSubstring(":4:8: \"Z-drive\" steers by turning its thrust"));
}

}  // namespace
}  // namespace swayaw
