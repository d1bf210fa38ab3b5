#include "swayaw/identification/regression.hpp"
#include "eigen.hpp"
#include "fit_words.hpp"
#include "module.hpp"

namespace swayaw::python {

template <>
struct Words<Residuals> {
  static std::vector<std::string> list() { return {"independent", "autoregressive"}; }
};
template <>
struct Words<StandardErrors> {
  static std::vector<std::string> list() { return {"of_model", "newey_west"}; }
};
template <>
struct Words<Solver> : NamedWords<Solver, 3, in_words> {};

namespace {

void add_estimate(py::module_& m) {
  Record<Estimate>(m, "Estimate",
                   "A number with its standard error; NaN, with infinite error, where data do not tell it.")
      .field<&Estimate::value>("value", "")
      .field<&Estimate::standard_error>("standard_error", "")
      .of()
      .def_property_readonly("verdict", &Estimate::verdict, "determined, weakly determined or not determined.")
      .def("__float__", [](const Estimate& e) { return e.value; });
}

// ---------------------------------------------------------------- results

void add_results(py::module_& m) {
  Record<Coefficient>(m, "Coefficient", "A coefficient and what the data tell of it.")
      .field<&Coefficient::name>("name", "Key of the ship file.")
      .field<&Coefficient::estimate>("estimate", "In the unit of the ship file.")
      .field<&Coefficient::low>("low", "95 % interval.")
      .field<&Coefficient::high>("high", "95 % interval.")
      .field<&Coefficient::variance_inflation>("variance_inflation", "1 where it is orthogonal to all others.")
      .field<&Coefficient::attenuation>("attenuation", "What errors of the features take of it.")
      .field<&Coefficient::undetermined>("undetermined", "It could change so much that its force were half of all.");
  Record<Combination>(m, "Combination", "A sum of coefficients that data do not determine.")
      .field<&Combination::terms>("terms", "Names and weights of coefficient times rms of its column, largest 1.")
      .field<&Combination::standard_error>("standard_error", "Over the rms of y; infinite where y does not see it.")
      .of()
      .def_property_readonly(
          "words", [](const Combination& c) { return in_words(c); }, "\"Y_v - 0.98 Y_r\"");
  Record<Regression>(m, "Regression", "Coefficients of y = X b + e and what the data tell of them.")
      .field<&Regression::status>("status", "converged, iteration limit or rank deficient.")
      .field<&Regression::solver>("solver", "normal equations, QR or SVD.")
      .field<&Regression::coefficients>("coefficients", "In the order of the columns.")
      .field<&Regression::covariance>("covariance", "Of the coefficients.")
      .field<&Regression::residuals>("residuals", "y - X b")
      .field<&Regression::residual_rms>("residual_rms", "Of them.")
      .field<&Regression::R2>("R2", "Share of the variance of y about its mean that is explained.")
      .field<&Regression::samples>("samples", "Effective number, less than the rows where residuals are correlated.")
      .field<&Regression::degrees_of_freedom>("degrees_of_freedom", "Of the intervals.")
      .field<&Regression::condition_number>("condition_number", "Of the features, columns scaled to one size.")
      .field<&Regression::undetermined>("undetermined", "Worst first.")
      .field<&Regression::autoregression>("autoregression", "phi of the residuals; empty where independent.")
      .field<&Regression::error_size>("error_size", "Factor on the covariances that total least squares finds; else 1.")
      .field<&Regression::iterations>("iterations", "Of autoregression or noise.")
      .of()
      .def(
          "__getitem__", [](const Regression& fit, const std::string& name) { return fit[name]; }, py::arg("name"),
          "The coefficient of that name; Refusal where there is none.");
}

// ---------------------------------------------------------------- regression

using PriorByName = std::map<std::string, std::pair<double, double>>;
using Sums = std::vector<std::pair<std::vector<std::pair<std::string, double>>, double>>;

std::vector<Prior> priors_from(const PriorByName& given) {
  std::vector<Prior> priors;
  for (const auto& [name, normal] : given) priors.push_back({name, normal.first, normal.second});
  return priors;
}

std::vector<Constraint> constraints_from(const Sums& given) {
  std::vector<Constraint> constraints;
  for (const auto& [terms, sum] : given) constraints.push_back({terms, sum});
  return constraints;
}

/// A covariance for all samples, or one for each. @throws std::domain_error  for arrays of other than 2 or 3 dimensions
std::vector<Eigen::MatrixXd> covariances_in(const std::optional<Array>& given) {
  std::vector<Eigen::MatrixXd> result;
  if (!given) return result;
  if (given->ndim() == 2) return {matrix_in(*given, "feature_covariance")};
  if (given->ndim() != 3)
    throw std::domain_error(fmt::format("feature_covariance must have 2 or 3 dimensions, got {}", given->ndim()));
  for (const auto& one : *given) result.push_back(matrix_in(one.cast<Array>(), "feature_covariance"));
  return result;
}

std::vector<std::string> names_or_numbers(std::optional<std::vector<std::string>> names, Eigen::Index columns) {
  if (names) return std::move(*names);
  std::vector<std::string> numbers;
  for (Eigen::Index i = 0; i < columns; ++i) numbers.push_back(fmt::format("b{}", i));
  return numbers;
}

void add_regress(py::module_& m) {
  m.def(
      "regress",
      [](const Array& X, const Array& y, std::optional<std::vector<std::string>> names, std::vector<Eigen::Index> runs,
         const std::optional<Array>& variance, bool variance_known, Residuals residuals, int order,
         StandardErrors standard_errors, double ridge, const PriorByName& priors, const Sums& constraints,
         const std::optional<Array>& feature_covariance, bool feature_size_known) {
        Design design{.names = {},
                      .X = matrix_in(X, "X"),
                      .y = vector_in(y, "y"),
                      .runs = std::move(runs),
                      .variance = variance ? vector_in(*variance, "variance") : Eigen::VectorXd()};
        design.names = names_or_numbers(std::move(names), design.X.cols());
        const RegressionOptions options{
            .residuals = residuals,
            .order = order,
            .standard_errors = standard_errors,
            .ridge = ridge,
            .priors = priors_from(priors),
            .constraints = constraints_from(constraints),
            .feature_errors = {.covariance = covariances_in(feature_covariance), .size_known = feature_size_known},
            .variance_known = variance_known};
        const py::gil_scoped_release unlocked;
        return regress(design, options);
      },
      py::arg("X"), py::arg("y"), py::arg("names") = py::none(), py::kw_only(),
      py::arg("runs") = std::vector<Eigen::Index>{}, py::arg("variance") = py::none(),
      py::arg("variance_known") = false, py::arg("residuals") = Residuals::independent, py::arg("order") = 1,
      py::arg("standard_errors") = StandardErrors::of_model, py::arg("ridge") = 0.0, py::arg("priors") = PriorByName{},
      py::arg("constraints") = Sums{}, py::arg("feature_covariance") = py::none(), py::arg("feature_size_known") = true,
      R"(Linear regression y = X b + e for forces: what data tell of each coefficient, and what they do not
(docs/identification.md).

X: features, samples by coefficients. y: what is explained. names: of the coefficients, b0, b1 … unless given. runs:
first row of each run, where there are several; the rows of a run follow each other in equal steps of time. variance: of
each y, up to a common factor; variance_known: they are the true ones. residuals: "independent", or "autoregressive" of
that `order` within a run. standard_errors: "of_model" or "newey_west". ridge: shrinks as if so many samples had said 0.
priors: {name: (mean, deviation)}. constraints: [([(name, weight), …], sum), …], held exactly. feature_covariance: of
the errors in (x, y), p + 1 by p + 1, one for all samples or one for each; feature_size_known=False takes it up to a
factor: total least squares. Source: [Prais1954], [Newey1994], [Andrews1992], [Fuller1987]

Raises Refusal if a name is not known, a number is not finite, constraints contradict each other or there are no more
samples than coefficients; ValueError if sizes do not fit or a variance or deviation is not positive.)");
  m.def(
      "correlation", [](const Regression& fit) { return array_of(correlation(fit)); }, py::arg("fit"),
      "Correlation of the estimates of a regression, coefficients by coefficients; NaN where one is not "
      "determined.\n\nfit: of `regress`.");
}

}  // namespace

void add_regression(py::module_& m) {
  add_estimate(m);
  add_results(m);
  add_regress(m);
}

}  // namespace swayaw::python
