#include <filesystem>

#include "casters.hpp"
#include "module.hpp"
#include "swayaw/app/sweep/plan.hpp"
#include "swayaw/app/sweep/store.hpp"
#include "swayaw/app/sweep/work.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::python {
namespace {

using app::SweepBlock, app::SweepStore, app::SweepWork;

std::unique_ptr<SweepWork> work_of(const std::filesystem::path& plan) {
  const auto read = app::read_sweep_plan(plan);
  if (app::of_recordings(read.task))
    throw Refusal(
        fmt::format("{}: recordings are worked on by the program: swayaw sweep {}", plan.string(), plan.string()));
  return std::make_unique<SweepWork>(read);
}

void add_work(py::module_& m) {
  py::class_<SweepBlock>(m, "SweepBlock", "Results of a block of items; goes between processes.")
      .def_property_readonly(
          "place", [](const SweepBlock& b) { return b.place; }, "Among the blocks.")
      .def_property_readonly(
          "count", [](const SweepBlock& b) { return b.count; }, "How many items.")
      .def(py::pickle(
          [](const SweepBlock& b) {
            return py::make_tuple(b.place, b.first, b.count,
                                  py::array_t<double>(static_cast<py::ssize_t>(b.values.size()), b.values.data()),
                                  b.notes);
          },
          [](const py::tuple& t) {
            const auto values = t[3].cast<py::array_t<double>>();
            return SweepBlock{.place = t[0].cast<std::size_t>(),
                              .first = t[1].cast<std::size_t>(),
                              .count = t[2].cast<std::size_t>(),
                              .values = {values.data(), values.data() + values.size()},
                              .notes = t[4].cast<std::vector<std::pair<std::size_t, std::string>>>()};
          }));
  py::class_<SweepWork>(
      m, "SweepWork",
      "What the plan of a sweep lays out: blocks of items that may be worked on anywhere, in any "
      "order, with the same results (docs/sweep.md).\n\nplan: its file (TOML). Raises FileError for a "
      "mistake in it, and Refusal for recordings, which the program works on.")
      .def(py::init(&work_of), py::arg("plan"))
      .def_property_readonly("items", &SweepWork::items, "How many.")
      .def_property_readonly("blocks", &SweepWork::blocks, "Of how many blocks they are.")
      .def_property_readonly("subjects", &SweepWork::subjects, "Names of the ships.")
      .def_property_readonly(
          "columns",
          [](const SweepWork& work) {
            std::vector<std::string> names;
            for (const auto& column : work.columns()) names.push_back(column.name);
            return names;
          },
          "Names of the columns; parameters that vary come first.")
      .def("block", &SweepWork::block, py::arg("place"), py::call_guard<py::gil_scoped_release>(),
           "Works on a block. Other threads go on meanwhile.\n\nplace: among the blocks.");
}

}  // namespace

void add_sweeps(py::module_& m) {
  add_work(m);
  py::class_<SweepStore>(
      m, "SweepStore",
      "Results of a sweep in FOLDER/sweep.sqlite; blocks are written whole or not at all.\n\nfolder: "
      "that the program would have for --out. work: whose results they are. Raises Refusal if the "
      "folder holds the results of another plan, or another sweep works in it.")
      .def(py::init<std::filesystem::path, const SweepWork&>(), py::arg("folder"), py::arg("work"),
           py::keep_alive<1, 3>())
      .def_property_readonly(
          "rest",
          [](const SweepStore& store) {
            std::vector<std::size_t> rest;
            for (std::size_t place = 0; place < store.done().size(); ++place)
              if (!store.done()[place]) rest.push_back(place);
            return rest;
          },
          "Blocks that are not there yet.")
      .def(
          "write",
          [](SweepStore& store, const std::vector<SweepBlock>& blocks) {
            const py::gil_scoped_release unlocked;
            store.write(blocks);
          },
          py::arg("blocks"), "All of these blocks or none. Raises Refusal if they cannot be written.\n\nblocks: any.")
      .def(
          "column",
          [](const SweepStore& store, std::size_t subject, std::size_t column) {
            const auto values = store.column(subject, column);
            return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
          },
          py::arg("subject"), py::arg("column"),
          "A column of every item of a ship, in their order; not a number where there is none.\n\nsubject: which ship. "
          "column: which of the columns.");
}

}  // namespace swayaw::python
