#include <matio.h>

#include <catch.hpp>
#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>

#include "files.hpp"
#include "swayaw/core/import.hpp"
#include "swayaw/core/refusal.hpp"

/// Variables of MATLAB files become columns of a table, to the last bit.
namespace swayaw {
namespace {

using Numbers = std::vector<double>;

/// A file written by libmatio.
class MatFile {
 public:
  MatFile(const std::filesystem::path& file, mat_ft version)
      : mat_(Mat_CreateVer(file.c_str(), nullptr, version), &Mat_Close) {
    REQUIRE(mat_ != nullptr);
  }

  static matvar_t* numbers(const char* name, std::size_t rows, std::size_t columns, const Numbers& values) {
    std::size_t dims[2] = {rows, columns};
    return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, const_cast<double*>(values.data()), 0);
  }

  static matvar_t* column(const char* name, const Numbers& values) { return numbers(name, values.size(), 1, values); }

  static matvar_t* text(const char* name, const std::string& value) {
    std::size_t dims[2] = {1, value.size()};
    return Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF8, 2, dims, const_cast<char*>(value.data()), 0);
  }

  static matvar_t* record(const char* name, std::vector<matvar_t*> fields, std::size_t elements = 1) {
    fields.push_back(nullptr);
    std::size_t dims[2] = {elements, 1};
    return Mat_VarCreate(name, MAT_C_STRUCT, MAT_T_STRUCT, 2, dims, fields.data(), 0);
  }

  static matvar_t* cells(const char* name, std::vector<matvar_t*> values) {
    std::size_t dims[2] = {1, values.size()};
    return Mat_VarCreate(name, MAT_C_CELL, MAT_T_CELL, 2, dims, values.data(), 0);
  }

  void write(matvar_t* variable, matio_compression compression = MAT_COMPRESSION_NONE) {
    REQUIRE(variable != nullptr);
    CHECK(Mat_VarWrite(mat_.get(), variable, compression) == 0);
    Mat_VarFree(variable);
  }

 private:
  std::unique_ptr<mat_t, int (*)(mat_t*)> mat_;
};

std::string refusal_of(const std::filesystem::path& file) {
  try {
    table_of_mat(file);
    return {};
  } catch (const FileError& error) {
    const std::string what = error.what();
    return what.substr(what.rfind('/') + 1);
  }
}

const Numbers time{0.0, 0.5, 1.0};
const Numbers psi{0.1, 1.0 / 3.0, -0.2};
const Numbers delta{10.0, std::nan(""), -10.0};

TEST_CASE("vectors come back to the last bit, rows or columns, in every version", "[core][import][round-trip]") {
  for (const auto version : {MAT_FT_MAT4, MAT_FT_MAT5, MAT_FT_MAT73}) {
    const test::Scratch scratch;
    {
      MatFile file(scratch / "run.mat", version);
      file.write(MatFile::column("delta", delta), version == MAT_FT_MAT5 ? MAT_COMPRESSION_ZLIB : MAT_COMPRESSION_NONE);
      file.write(MatFile::numbers("psi_rad", 1, 3, psi));
      file.write(MatFile::column("time", time));
      file.write(MatFile::column("L", {230.0}));
    }
    CHECK(table_of_mat(scratch / "run.mat") == "delta,psi_rad,time\n10,0.1,0\n,0.3333333333333333,0.5\n-10,-0.2,1\n");
  }
}

TEST_CASE("whole numbers of every kind are numbers", "[core][import]") {
  const test::Scratch scratch;
  {
    MatFile file(scratch / "run.mat", MAT_FT_MAT5);
    std::size_t dims[2] = {3, 1};
    std::int16_t small[3] = {-3, 0, 300};
    float single[3] = {0.5F, 1.5F, -2.0F};
    file.write(Mat_VarCreate("small", MAT_C_INT16, MAT_T_INT16, 2, dims, small, 0));
    file.write(Mat_VarCreate("single", MAT_C_SINGLE, MAT_T_SINGLE, 2, dims, single, 0));
  }
  CHECK(table_of_mat(scratch / "run.mat") == "small,single\n-3,0.5\n0,1.5\n300,-2\n");
}

TEST_CASE("a matrix takes its names from a list of as many", "[core][import]") {
  const Numbers both{0.0, 0.5, 1.0, 7.0, 8.0, 9.0};
  for (const auto version : {MAT_FT_MAT5, MAT_FT_MAT73}) {
    const test::Scratch scratch;
    {
      MatFile file(scratch / "run.mat", version);
      file.write(MatFile::numbers("data", 3, 2, both));
      file.write(MatFile::cells("names", {MatFile::text(nullptr, "t, s"), MatFile::text(nullptr, "Heading [deg]")}));
    }
    CHECK(table_of_mat(scratch / "run.mat") == "\"t, s\",Heading [deg]\n0,7\n0.5,8\n1,9\n");
  }
  const test::Scratch scratch;
  {
    MatFile file(scratch / "run.mat", MAT_FT_MAT5);
    file.write(MatFile::numbers("data", 3, 2, both));
  }
  CHECK(table_of_mat(scratch / "run.mat") == "data_1,data_2\n0,7\n0.5,8\n1,9\n");
}

TEST_CASE("fields of a struct are columns, also of structs within it", "[core][import]") {
  for (const auto version : {MAT_FT_MAT5, MAT_FT_MAT73}) {
    const test::Scratch scratch;
    {
      MatFile file(scratch / "run.mat", version);
      file.write(MatFile::record("log", {MatFile::column("t", time), MatFile::text("ship", "KCS"),
                                         MatFile::record("gyro", {MatFile::column("psi", psi)})}));
    }
    CHECK(table_of_mat(scratch / "run.mat") == "t,psi\n0,0.1\n0.5,0.3333333333333333\n1,-0.2\n");
  }
}

TEST_CASE("an array of structs has a row for each", "[core][import]") {
  const test::Scratch scratch;
  {
    MatFile file(scratch / "run.mat", MAT_FT_MAT5);
    std::vector<matvar_t*> fields;
    for (std::size_t i = 0; i < 3; ++i) {
      fields.push_back(MatFile::column("t", {time[i]}));
      fields.push_back(MatFile::column("psi", {psi[i]}));
    }
    file.write(MatFile::record("rows", fields, 3));
  }
  CHECK(table_of_mat(scratch / "run.mat") == "t,psi\n0,0.1\n0.5,0.3333333333333333\n1,-0.2\n");
}

TEST_CASE("structs of Time and Data come to all their times", "[core][import]") {
  for (const auto version : {MAT_FT_MAT5, MAT_FT_MAT73}) {
    const test::Scratch scratch;
    {
      MatFile file(scratch / "run.mat", version);
      file.write(MatFile::record("delta", {MatFile::column("Time", {0.0, 0.75}), MatFile::column("Data", {5.0, 6.0}),
                                           MatFile::text("Name", "rudder angle")}));
      file.write(MatFile::record("psi", {MatFile::column("Time", time), MatFile::column("Data", psi)}));
    }
    CHECK(table_of_mat(scratch / "run.mat") ==
          "Time,rudder angle,psi\n0,5,0.1\n0.5,,0.3333333333333333\n0.75,6,\n1,,-0.2\n");
  }
}

TEST_CASE("run keys stand above the columns, so that the side of the rudder is not lost", "[core][import]") {
  const test::Scratch scratch;
  {
    MatFile file(scratch / "run.mat", MAT_FT_MAT5);
    file.write(MatFile::column("time_s", time));
    file.write(MatFile::column("psi_rad", psi));
    file.write(MatFile::column("delta_deg", delta));
    file.write(MatFile::text("rudder_positive", "starboard"));
    file.write(MatFile::column("execute_s", {0.5}));
    file.write(MatFile::text("ship", "KCS"));
  }
  CHECK(table_of_mat(scratch / "run.mat")
            .starts_with("# rudder_positive = \"starboard\"\n# execute_s = 0.5\ntime_s,psi_rad,delta_deg\n"));
  const auto text = import_mat(scratch / "run.mat", {}).text;
  CHECK(text.find("# rudder_positive = \"starboard\"") != std::string::npos);
}

TEST_CASE("variables of another length are left out", "[core][import]") {
  const test::Scratch scratch;
  {
    MatFile file(scratch / "run.mat", MAT_FT_MAT5);
    file.write(MatFile::column("t", time));
    file.write(MatFile::column("long", {1.0, 2.0, 3.0, 4.0}));
    file.write(MatFile::column("psi", psi));
  }
  CHECK(table_of_mat(scratch / "run.mat").starts_with("t,psi\n"));
}

TEST_CASE("what is no MATLAB file or holds no columns is refused in one line", "[core][import][refusal]") {
  const test::Scratch scratch;
  CHECK(refusal_of(scratch / "none.mat") ==
        "none.mat:1:1: not a MATLAB file of version 4 to 7.3, or it cannot be read");
  std::ofstream(scratch / "text.mat") << "time_s,psi_deg\n1,2\n";
  CHECK(refusal_of(scratch / "text.mat").starts_with("text.mat:1:1: no"));
  { MatFile(scratch / "scalar.mat", MAT_FT_MAT5).write(MatFile::column("L", {230.0})); }
  CHECK(refusal_of(scratch / "scalar.mat") ==
        "scalar.mat:1:1: no numbers in columns: no variable is a vector, a matrix or a struct of vectors");
}

TEST_CASE("a MATLAB file that is cut is read as far as it goes, or refused", "[core][import][fuzz]") {
  const test::Scratch scratch;
  {
    MatFile file(scratch / "whole.mat", MAT_FT_MAT5);
    file.write(MatFile::column("time", time));
    file.write(MatFile::column("psi", psi));
    file.write(MatFile::record("log", {MatFile::column("Time", time), MatFile::column("Data", delta)}));
  }
  std::ifstream in(scratch / "whole.mat", std::ios::binary);
  std::ostringstream whole;
  whole << in.rdbuf();
  const auto bytes = whole.str();
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    std::ofstream(scratch / "cut.mat", std::ios::binary) << bytes.substr(0, size);
    const auto refusal = refusal_of(scratch / "cut.mat");
    INFO(size << " bytes: " << refusal);
    CHECK(refusal.find('\n') == std::string::npos);
  }
}

}  // namespace
}  // namespace swayaw
