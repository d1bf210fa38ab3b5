#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "fleet_class.hpp"
#include "linear_gaussian.hpp"
#include "swayaw/mismatch/fleet.hpp"

/// Days of sister ships as a linear model: class, vessel, day, and changes in time. Not installed.
namespace swayaw::inline mismatch::detail {

/// A change of one watched number of a vessel.
struct Shift {
  std::size_t watched;
  ChangeShape shape;
  double since;

  /// 0 before, 1 on the last day.
  double at(double date, double last) const {
    if (date < since) return 0.0;
    return shape == ChangeShape::sudden || last <= since ? 1.0 : (date - since) / (last - since);
  }
};

/// How far vessels and days lie apart.
struct Spread {
  double vessels = 0.25;                     ///< coefficients of a vessel from those of the class, over `[confidence]`
  double days = 0.0625;                      ///< of a day from those of the vessel
  std::vector<std::vector<double>> watched;  ///< of the days of each vessel, over the least size that matters
};

/// What the days of all vessels tell, with shifts and spreads as they stand.
class FleetModel {
 public:
  FleetModel(const ClassTrial& whole, std::vector<Day> days, std::size_t vessels);

  const std::vector<Day>& days() const { return *days_; }
  const Spread& spread() const { return spread_; }
  std::size_t vessels() const { return shifts_.size(); }
  const std::vector<Shift>& shifts(std::size_t vessel) const { return shifts_[vessel]; }
  double last(std::size_t vessel) const { return last_[vessel]; }
  double log_evidence() const { return log_evidence_; }

  /// The same with one more shift, the scatter of what it moves as is likeliest with it.
  FleetModel with(std::size_t vessel, const Shift& shift) const;

  /// The same without one of her shifts, spreads as they are.
  FleetModel without(std::size_t vessel, std::size_t shift) const;

  /// The same with the scatter of the days of a vessel in what is watched as is likeliest.
  FleetModel with_likely_scatter(std::size_t vessel, std::size_t watched) const;

  /// The same with days of a vessel that hardly scatter in what is watched: a shift stands out.
  FleetModel with_little_scatter(std::size_t vessel, std::size_t watched) const;

  /// The days anew about what the fleet tells of them.
  void move_days();

  /// The last shift of a vessel in another place of her list.
  void move_last_to(std::size_t vessel, std::size_t place);

  /// Spreads at which the days are likeliest.
  void find_spreads();

  /// Of a vessel: coordinates that are kept, then the size of each of her shifts.
  NormalLaw law_of(std::size_t vessel) const;

  /// Coordinates of a vessel in two parts: what her class has, and what is her own with its standard error.
  struct OwnLaw {
    Eigen::VectorXd of_class, own, error;
  };

  OwnLaw own_law_of(std::size_t vessel) const;

  /// Coordinates of a vessel on a day, by her law.
  Eigen::VectorXd coordinates_on(const Day& day, const NormalLaw& law) const { return map_of(day) * law.mean; }

  /// Of what the class has in common.
  NormalLaw law_of_class() const;

  /// Gain in log evidence of one more shift, for each of these dates, spreads as they are.
  std::vector<double> gains(std::size_t vessel, std::size_t watched, ChangeShape shape, std::span<const double> dates,
                            const NormalLaw& law) const;

 private:
  /// Of a vessel: coordinates of the class as her sisters and her own days tell them, what is her own, and the size of
  /// each of her shifts.
  NormalLaw law_in_parts(std::size_t vessel) const;

  /// From those to the coordinates of the vessel and the sizes of her shifts.
  Eigen::MatrixXd sum_of_parts(std::size_t vessel) const;

  /// Deviations of a vessel from the class.
  Eigen::VectorXd own_deviations() const;

  double deviation_of(const Shift& shift) const { return whole_->watched[shift.watched].deviation; }

  /// From the coordinates of a vessel, her shifts among them, to those of a day.
  Eigen::MatrixXd map_of(const Day& day) const;

  /// What follows from the spreads, of all vessels.
  void renew();

  void renew(std::size_t vessel) { renew_told(vessel), renew_evidence(); }

  void renew_told(std::size_t vessel);

  void renew_evidence();

  /// Moves one spread by factors of 2 as long as the evidence grows.
  void climb(double& spread, double most, const std::function<void()>& renew_with);

  void climb_watched(std::size_t vessel, std::size_t k);

  const ClassTrial* whole_;
  std::shared_ptr<const std::vector<Day>> days_;  ///< the same in models that differ in shifts and spreads
  std::vector<std::vector<Shift>> shifts_;        ///< of each vessel
  std::vector<double> last_;
  Spread spread_{};
  std::vector<Told> scattered_;  ///< by day, its scatter eliminated
  std::vector<Told> of_vessel_;  ///< of her coordinates and the sizes of her shifts
  std::vector<Told> of_class_;   ///< what each vessel tells of the class
  double log_evidence_ = -HUGE_VAL;
};

}  // namespace swayaw::mismatch::detail
