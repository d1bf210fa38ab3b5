#include <matio.h>

#include <catch.hpp>
#include <cmath>
#include <fstream>
#include <memory>

#include "files.hpp"
#include "recording_text.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/mat_file.hpp"

/// A recording is the same in a MATLAB file: columns and run keys by their names.
namespace swayaw {
namespace {

using test::recording_of;

MatVariable column(const char* name, std::vector<double> values) { return {name, mat_column(std::move(values))}; }

MatVariable text(const char* name, std::string value) { return {name, {std::move(value)}}; }

const MatVariable time = column("time_s", {0.0, 0.5, 1.0});
const MatVariable psi = column("psi_deg", {359.5, 0.1, 1.0 / 3.0});
const MatVariable delta = column("delta_deg", {10.0, std::nan(""), -10.0});

RecordingFile written(const std::vector<MatVariable>& variables) {
  const test::Scratch scratch;
  write_mat(scratch / "run.mat", variables);
  return read_recording(scratch / "run.mat");
}

std::string refusal_of(const std::vector<MatVariable>& variables) {
  try {
    written(variables);
    return {};
  } catch (const FileError& error) {
    const std::string what = error.what();
    return what.substr(what.rfind("run.mat"));
  }
}

TEST_CASE("variables are read as the columns and run keys of a text are", "[core][second-route]") {
  const auto from_text = recording_of(
      "# rudder_positive = \"starboard\"\n# reference_x_m = 3.5\n# execute_s = 0.25\n# group = \"Größe 1\"\n"
      "time_s,psi_deg,delta_deg,remark\n0,359.5,10,\"a, b\"\n0.5,0.1,,\n1,0.3333333333333333,-10,c\n");
  const std::vector<MatVariable> variables{time,
                                           psi,
                                           delta,
                                           {"remark", mat_texts({"a, b", "", "c"})},
                                           text("rudder_positive", "starboard"),
                                           {"reference_x_m", mat_number(3.5)},
                                           {"execute_s", mat_number(0.25)},
                                           text("group", "Größe 1")};
  for (const auto& file : {written(variables), written({{"run", {MatStruct{variables}}}, column("other", {1, 2})})}) {
    const auto& run = file.recording;
    CHECK(recording_text(run) == recording_text(from_text));
    CHECK(run[Channel::delta][0] == -radians(10.0));
    REQUIRE(file.warnings.size() == 1);
    CHECK(file.warnings[0] == "run.mat: column remark is not understood; kept as it is");
  }
}

TEST_CASE("run keys keep their kind, and names become those of MATLAB", "[core][round-trip]") {
  const auto run = recording_of(
      "# manoeuvre = \"zigzag 10/10\"\n# loaded = true\n# draughts_m = [10.5, 11]\n# day = 2020-07-31\n"
      "# extra_columns = [\"Größe [t]\", \"mast\"]\n"
      "time_s,psi_rad,delta_rad,Größe [t],mast\n0,0,0,1.5,up\n1,0,0,,down\n");
  const test::Scratch scratch;
  write_recording(run, scratch / "run.mat");
  const auto back = read_recording(scratch / "run.mat");
  CHECK(back.warnings.empty());
  CHECK(recording_text(back.recording) ==
        "# rudder_positive = \"port\"\n# manoeuvre = \"zigzag 10/10\"\n# loaded = true\n"
        "# draughts_m = [10.5, 11]\n# day = \"2020-07-31\"\n# extra_columns = [\"Gr__e__t_\", \"mast\"]\n"
        "time_s,psi_rad,delta_rad,Gr__e__t_,mast\n0,0,0,1.5,up\n1,0,0,,down\n");
}

TEST_CASE("what is no recording is refused, naming the variable", "[core][refusal]") {
  CHECK(refusal_of({psi, delta}) ==
        "run.mat:1:1: no variable time_s, nor a struct with that field; swayaw import reads files whose variables have "
        "other names");
  CHECK(refusal_of({time, psi}) ==
        "run.mat:1:1: no rudder column (delta_rad, delta_deg, delta_order_rad or delta_order_deg)");
  CHECK(refusal_of({time, column("psi_deg", {1.0, 2.0}), delta}) ==
        "run.mat:1:1: variable psi_deg has 2 numbers, and time_s has 3");
  CHECK(refusal_of({time, text("psi_deg", "north"), delta}) ==
        "run.mat:1:1: variable psi_deg is not a vector of numbers");
  CHECK(refusal_of({column("time_s", {0.0, 2.0, 1.0}), psi, delta}) ==
        "run.mat:1:1: time_s must increase, got 1 after 2");
  CHECK(refusal_of({column("time_s", {}), psi, delta}) ==
        "run.mat:1:1: variable psi_deg has 3 numbers, and time_s has 0");
  CHECK(refusal_of({column("time_s", {0.0, HUGE_VAL, 1.0}), psi, delta}) ==
        "run.mat:1:1: \"inf\" in column time_s is not a number");
  CHECK(refusal_of({text("rudder_positive", "left"), time, psi, delta}) ==
        "run.mat:1:1: rudder_positive must be \"port\" or \"starboard\", got \"left\"");
  CHECK(refusal_of({{"a", {MatStruct{{time}}}}, {"b", {MatStruct{{time}}}}}) ==
        "run.mat:1:1: holds several structs with time_s; a file is one recording");
}

TEST_CASE("variables that are neither columns nor run keys are left out and named", "[core][import]") {
  const auto warnings = written({time, psi, delta, {"map", {MatStruct{{psi}}}}, column("few", {1.0, 2.0})}).warnings;
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0] == "run.mat: variable map is neither a column of 3 samples nor a run key; left out");
}

TEST_CASE("values come back from a MATLAB file as they were", "[core][round-trip]") {
  const test::Scratch scratch;
  const MatValue two{MatCell{{{std::string("ä€")}, {MatStruct{{{"k", mat_number(1.0 / 3.0)}, {"on", {true}}}}}}}};
  write_mat(scratch / "a.mat",
            {{"two", two}, {"empty", {std::string{}}}, {"A", {MatNumbers{2, 3, {1, 2, 3, 4, 5, 6}}}}});
  const auto back = read_mat(scratch / "a.mat");
  REQUIRE(back.size() == 3);
  const auto& cell = std::get<MatCell>(back[0].value.is).values;
  CHECK(std::get<std::string>(cell.at(0).is) == "ä€");
  const auto& fields = std::get<MatStruct>(cell.at(1).is).fields;
  CHECK(std::get<MatNumbers>(fields.at(0).value.is).values == std::vector{1.0 / 3.0});
  CHECK(std::get<bool>(fields.at(1).value.is));
  CHECK(std::get<std::string>(back[1].value.is).empty());
  const auto& A = std::get<MatNumbers>(back[2].value.is);
  CHECK((A.rows == 2 && A.columns == 3 && A.values == std::vector<double>{1, 2, 3, 4, 5, 6}));
}

TEST_CASE("a recording that is cut is read as far as it goes, or refused", "[core][fuzz]") {
  const test::Scratch scratch;
  write_mat(scratch / "whole.mat", {time, psi, delta, {"texts", mat_texts({"a", "b"})}, {"s", {MatStruct{{psi}}}}});
  const auto bytes = read_text(scratch / "whole.mat");
  for (std::size_t size = 0; size < bytes.size(); size += 5) {
    write_text(scratch / "cut.mat", bytes.substr(0, size));
    try {
      const auto run = read_recording(scratch / "cut.mat").recording;
      CHECK(run.samples() == 3);
    } catch (const FileError& error) {
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
    }
  }
}

TEST_CASE("a MATLAB file that cannot be written leaves the old one", "[core][refusal]") {
  const test::Scratch scratch;
  CHECK_THROWS_AS(write_mat(scratch / "no_folder" / "a.mat", {time}), FileError);
  std::filesystem::create_directory(scratch / "a.mat");
  CHECK_THROWS_AS(write_mat(scratch / "a.mat", {time}), FileError);
  CHECK(std::filesystem::is_directory(scratch / "a.mat"));
}

/// Zeros as MATLAB saves them: compressed to a thousandth, in a struct or by themselves.
void write_zeros(const std::filesystem::path& file, std::size_t count, bool in_struct) {
  std::vector<double> zeros(count, 0.0);
  std::size_t dims[2] = {count, 1}, one[2] = {1, 1};
  const std::unique_ptr<mat_t, int (*)(mat_t*)> mat(Mat_CreateVer(file.c_str(), nullptr, MAT_FT_MAT5), &Mat_Close);
  auto* values = Mat_VarCreate("time_s", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, zeros.data(), 0);
  matvar_t* fields[] = {values, nullptr};
  auto* whole = in_struct ? Mat_VarCreate("run", MAT_C_STRUCT, MAT_T_STRUCT, 2, one, fields, 0) : values;
  Mat_VarWrite(mat.get(), whole, MAT_COMPRESSION_ZLIB);
  Mat_VarFree(whole);
}

TEST_CASE("what is compressed counts as it will be when it is read", "[core][refusal]") {
  const test::Scratch scratch;
  for (const bool in_struct : {false, true}) {
    const auto file = scratch / "zeros.mat";
    write_zeros(file, 1'000'000, in_struct);
    CHECK(std::filesystem::file_size(file) < 20'000);
    CHECK(read_mat(file).size() == 1);
    set_largest_file(1'000'000);
    CHECK_THROWS_WITH(read_mat(file), ContainsSubstring("its variables have 8 MB, and up to 1 MB are read here; "
                                                        "--max-file-size "));
    set_largest_file(0);
  }
}

}  // namespace
}  // namespace swayaw
