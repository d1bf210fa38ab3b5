// A ship as a unit of FMI 2.0 for co-simulation, over the C interface.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/refusal.hpp"
#include "variables.hpp"

#pragma GCC visibility push(default)
#include "fmi2.h"
#pragma GCC visibility pop

namespace swayaw::fmu {
namespace {

enum Phase : unsigned { instantiated = 1, initializing = 2, stepping = 4, terminated = 8, any = 15 };

std::string_view words_for(Phase phase) {
  switch (phase) {
    case instantiated: return "before initialization";
    case initializing: return "during initialization";
    case stepping: return "while it is simulated";
    default: return "once it is terminated";
  }
}

/// "%20" and the like undone.
std::string decoded(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '%' && i + 2 < text.size();
    plain += escape ? static_cast<char>(std::stoi(std::string(text.substr(i + 1, 2)), nullptr, 16)) : text[i];
    if (escape) i += 2;
  }
  return plain;
}

/// The folder of "file:///folder", "file:/folder" or "file://localhost/folder".
std::filesystem::path folder_of(fmi2String uri) {
  std::string_view rest = uri == nullptr ? "" : uri;
  if (!rest.starts_with("file:"))
    throw Refusal(fmt::format("the location of the resources must be a file URI, got \"{}\"", rest));
  rest.remove_prefix(5);
  if (rest.starts_with("//")) rest.remove_prefix(std::min(rest.find('/', 2), rest.size()));
  return decoded(rest);
}

class Instance {
 public:
  Instance(fmi2String name, const fmi2CallbackFunctions& functions, std::filesystem::path resources)
      : name_(name),
        functions_(functions),
        resources_(std::move(resources)),
        variables_(variables_of(path_of(std::string(default_ship_file)))) {}

  void require_guid(std::string_view guid) const {
    if (guid != guid_of(read_text(path_of(std::string(default_ship_file))), variables_))
      throw Refusal(fmt::format("{} is not the ship that modelDescription.xml was made of; name another in ship_file",
                                path_of(std::string(default_ship_file))));
  }

  void log(fmi2Status status, std::string_view category, const std::string& message) const {
    if (functions_.logger == nullptr || (status == fmi2OK && !told_all_)) return;
    functions_.logger(functions_.componentEnvironment, name_.c_str(), status, std::string(category).c_str(), "%s",
                      message.c_str());
  }

  void tell_all(bool all) { told_all_ = all; }

  void require(unsigned phases, std::string_view function) const {
    if ((phases & phase_) == 0) throw Refusal(fmt::format("{} cannot be called {}", function, words_for(phase_)));
  }

  // ------------------------------------------------------------ the course of a simulation

  void set_up(double start, std::optional<double> stop) {
    if (!std::isfinite(start) || (stop && !(*stop >= start)))
      throw Refusal(fmt::format("a simulation cannot run from {} s to {} s", start, stop.value_or(start)));
    start_ = start, stop_ = stop;
  }

  void enter(Phase phase) {
    if (phase == stepping) {
      validity_ = value_of(ship(), "validity");
      log(fmi2OK, "logEvents", fmt::format("begins at {} m/s", value_of(ship(), "u_m_s")));
    }
    phase_ = phase;
  }

  void reset() {
    file_ = default_ship_file, speed_ = 0.0, place_ = {};
    orders_.clear(), ship_.reset();
    start_ = 0.0, stop_.reset();
    phase_ = instantiated;
  }

  double time() { return start_ + value_of(ship(), "time_s"); }

  fmi2Status step(double now, double dt) {
    if (!(dt >= 0.0) || !std::isfinite(dt)) throw Refusal(fmt::format("a step must not be negative, got {} s", dt));
    if (!(std::abs(now - time()) <= 1e-6 * (1.0 + std::abs(now))))
      throw Refusal(fmt::format("the step begins at {} s, the ship is at {} s", now, time()));
    if (stop_ && now + dt > *stop_ + 1e-6 * (1.0 + std::abs(*stop_)))
      throw Refusal(fmt::format("a step to {} s goes beyond the stop time {} s", now + dt, *stop_));
    if (dt > 0.0 && swayaw_step(&ship(), dt) != 0) throw Refusal(swayaw_error());
    return warn_of_validity();
  }

  // ------------------------------------------------------------ values

  double real(fmi2ValueReference reference) {
    const auto& v = variable(reference, Type::real);
    switch (reference) {
      case start_speed: return ship(), begun_at_;
      case start_x: return place_.x;
      case start_y: return place_.y;
      case start_psi: return place_.psi;
      default: return v.causality == Causality::independent ? time() : value_of(ship(), v.name);
    }
  }

  int integer(fmi2ValueReference reference) {
    return static_cast<int>(value_of(ship(), variable(reference, Type::integer).name));
  }

  int boolean(fmi2ValueReference reference) {
    variable(reference, Type::boolean);
    return value_of(ship(), "validity") == 0.0 ? fmi2True : fmi2False;
  }

  /// Valid until the ship file is set anew.
  fmi2String text(fmi2ValueReference reference) {
    variable(reference, Type::string);
    return reference == ship_file ? file_.c_str() : swayaw_why(&ship());
  }

  void set_real(fmi2ValueReference reference, double value) {
    const auto& v = settable(reference, Type::real);
    if (!std::isfinite(value)) throw Refusal(fmt::format("{} must be a finite number, got {}", v.name, value));
    if (phase_ == stepping) return order(ship(), v.name, value);
    switch (reference) {
      case start_speed: speed_ = require_positive(value, "start.speed_m_s"); break;
      case start_x: place_.x = value; break;
      case start_y: place_.y = value; break;
      case start_psi: place_.psi = value; break;
      default: orders_[v.name] = value;
    }
    ship_.reset();
  }

  void set_text(fmi2ValueReference reference, fmi2String value) {
    const auto& v = settable(reference, Type::string);
    const std::filesystem::path file = value == nullptr ? "" : value;
    if (file.empty() || file.has_parent_path())
      throw Refusal(
          fmt::format("{} is the name of a file in {}, got \"{}\"", v.name, resources_.string(), file.string()));
    file_ = file.string();
    ship_.reset();
  }

  const Variable& settable(fmi2ValueReference reference, Type type) const {
    const auto& v = variable(reference, type);
    if (v.causality != Causality::input && v.causality != Causality::parameter)
      throw Refusal(fmt::format("{} is an output and cannot be set", v.name));
    if (v.causality == Causality::parameter && phase_ == stepping)
      throw Refusal(fmt::format("{} is a parameter and cannot be set {}", v.name, words_for(phase_)));
    return v;
  }

 private:
  struct Place {
    double x = 0.0, y = 0.0, psi = 0.0;
  };

  static void order(swayaw_ship& ship, const std::string& name, double value) {
    if (swayaw_set(&ship, name.c_str(), value) != 0) throw Refusal(swayaw_error());
  }

  std::string path_of(const std::string& file) const { return (resources_ / file).string(); }

  const Variable& variable(fmi2ValueReference reference, Type type) const {
    for (const auto& v : variables_)
      if (v.reference == reference && v.type == type) return v;
    static constexpr std::string_view types[] = {"Real", "Integer", "Boolean", "String"};
    throw Refusal(fmt::format("there is no {} with the value reference {}", types[static_cast<int>(type)], reference));
  }

  /// Before she is simulated she is made anew whenever something about her start was set.
  swayaw_ship& ship() {
    if (ship_) return *ship_;
    auto made = open_ship(path_of(file_), speed_);
    begun_at_ = value_of(*made, "u_m_s");
    if (place_.x != 0.0) order(*made, "x_m", place_.x);
    if (place_.y != 0.0) order(*made, "y_m", place_.y);
    if (place_.psi != 0.0) order(*made, "psi_rad", place_.psi);
    for (const auto& [name, value] : orders_) order(*made, name, value);
    ship_ = std::move(made);
    return *ship_;
  }

  fmi2Status warn_of_validity() {
    const double validity = value_of(ship(), "validity");
    if (validity == std::exchange(validity_, validity)) return fmi2OK;
    const auto status = validity == 0.0 ? fmi2OK : fmi2Warning;
    log(status, status == fmi2OK ? "logEvents" : "logStatusWarning",
        fmt::format("{} s: {}", time(), swayaw_why(&ship())));
    return status;
  }

  std::string name_;
  fmi2CallbackFunctions functions_;
  std::filesystem::path resources_;
  std::vector<Variable> variables_;
  Phase phase_ = instantiated;
  bool told_all_ = false;
  double start_ = 0.0;
  std::optional<double> stop_;
  std::string file_{default_ship_file};
  double speed_ = 0.0;                    ///< at the start [m/s]; 0 for the service speed
  double begun_at_ = 0.0;                 ///< that speed
  Place place_;                           ///< at the start
  std::map<std::string, double> orders_;  ///< until she is simulated
  ShipHandle ship_;
  double validity_ = 0.0;  ///< after the last step
};

/// What `work` comes to in one of these phases. No exception passes; its words go to the logger.
template <class Work>
fmi2Status guarded(fmi2Component component, unsigned phases, std::string_view function, const Work& work) noexcept {
  if (component == nullptr) return fmi2Error;
  auto& instance = *static_cast<Instance*>(component);
  try {
    instance.require(phases, function);
    if constexpr (std::is_void_v<decltype(work(instance))>) return work(instance), fmi2OK;
    else return work(instance);
  } catch (const std::exception& e) {
    instance.log(fmi2Error, "logStatusError", e.what());
  }
  return fmi2Error;
}

template <class Value, class Get>
fmi2Status read(fmi2Component c, std::string_view function, const fmi2ValueReference vr[], std::size_t nvr,
                Value value[], const Get& get) {
  return guarded(c, any, function, [&](Instance& i) {
    for (std::size_t k = 0; k < nvr; ++k) value[k] = (i.*get)(vr[k]);
  });
}

template <class Value, class Set>
fmi2Status write(fmi2Component c, std::string_view function, const fmi2ValueReference vr[], std::size_t nvr,
                 const Value value[], const Set& set) {
  return guarded(c, instantiated | initializing | stepping, function, [&](Instance& i) {
    for (std::size_t k = 0; k < nvr; ++k) set(i, vr[k], value[k]);
  });
}

fmi2Status refuse(fmi2Component c, std::string_view function) {
  return guarded(c, any, function,
                 [&](Instance&) { throw Refusal(fmt::format("{}: this ship does not offer it", function)); });
}

}  // namespace
}  // namespace swayaw::fmu

using namespace swayaw::fmu;

const char* fmi2GetTypesPlatform() { return fmi2TypesPlatform; }
const char* fmi2GetVersion() { return fmi2Version; }

fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t count, const fmi2String categories[]) {
  return guarded(c, any, __func__, [&](Instance& i) {
    bool events = count == 0;
    for (size_t k = 0; k < count; ++k) events = events || std::string_view(categories[k]) == "logEvents";
    i.tell_all(on != fmi2False && events);
  });
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions* functions, fmi2Boolean, fmi2Boolean logging_on) {
  if (functions == nullptr) return nullptr;
  const auto* shown = name == nullptr || *name == '\0' ? "ship" : name;
  try {
    if (type != fmi2CoSimulation) throw swayaw::Refusal("this unit is for co-simulation, not for model exchange");
    auto instance = std::make_unique<Instance>(shown, *functions, folder_of(resources));
    instance->require_guid(guid == nullptr ? "" : guid);
    instance->tell_all(logging_on != fmi2False);
    return instance.release();
  } catch (const std::exception& e) {
    if (functions->logger != nullptr)
      functions->logger(functions->componentEnvironment, shown, fmi2Error, "logStatusError", "%s", e.what());
  }
  return nullptr;
}

void fmi2FreeInstance(fmi2Component c) { delete static_cast<Instance*>(c); }

fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean, fmi2Real, fmi2Real start, fmi2Boolean stop_defined,
                               fmi2Real stop) {
  return guarded(c, instantiated, __func__,
                 [&](Instance& i) { i.set_up(start, stop_defined != fmi2False ? std::optional(stop) : std::nullopt); });
}

fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
  return guarded(c, instantiated, __func__, [](Instance& i) { i.enter(initializing); });
}

fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  return guarded(c, initializing, __func__, [](Instance& i) { i.enter(stepping); });
}

fmi2Status fmi2Terminate(fmi2Component c) {
  return guarded(c, stepping, __func__, [](Instance& i) { i.enter(terminated); });
}

fmi2Status fmi2Reset(fmi2Component c) {
  return guarded(c, any, __func__, [](Instance& i) { i.reset(); });
}

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Real value[]) {
  return read(c, __func__, vr, nvr, value, &Instance::real);
}

fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Integer value[]) {
  return read(c, __func__, vr, nvr, value, &Instance::integer);
}

fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2Boolean value[]) {
  return read(c, __func__, vr, nvr, value, &Instance::boolean);
}

fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, fmi2String value[]) {
  return read(c, __func__, vr, nvr, value, &Instance::text);
}

fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2Real value[]) {
  return write(c, __func__, vr, nvr, value, [](Instance& i, auto ref, double x) { i.set_real(ref, x); });
}

fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2Integer value[]) {
  return write(c, __func__, vr, nvr, value, [](Instance& i, auto ref, int) { i.settable(ref, Type::integer); });
}

fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2Boolean value[]) {
  return write(c, __func__, vr, nvr, value, [](Instance& i, auto ref, int) { i.settable(ref, Type::boolean); });
}

fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], size_t nvr, const fmi2String value[]) {
  return write(c, __func__, vr, nvr, value, [](Instance& i, auto ref, fmi2String x) { i.set_text(ref, x); });
}

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate*) { return refuse(c, __func__); }
fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate) { return refuse(c, __func__); }
fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* state) {
  return state == nullptr || *state == nullptr ? fmi2OK : refuse(c, __func__);
}
fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate, size_t*) { return refuse(c, __func__); }
fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate, fmi2Byte[], size_t) { return refuse(c, __func__); }
fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte[], size_t, fmi2FMUstate*) {
  return refuse(c, __func__);
}
fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference[], size_t, const fmi2ValueReference[],
                                        size_t, const fmi2Real[], fmi2Real[]) {
  return refuse(c, __func__);
}
fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference[], size_t, const fmi2Integer[],
                                       const fmi2Real[]) {
  return refuse(c, __func__);
}
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference[], size_t, const fmi2Integer[],
                                        fmi2Real[]) {
  return refuse(c, __func__);
}

fmi2Status fmi2DoStep(fmi2Component c, fmi2Real now, fmi2Real dt, fmi2Boolean) {
  return guarded(c, stepping, __func__, [&](Instance& i) { return i.step(now, dt); });
}

fmi2Status fmi2CancelStep(fmi2Component c) { return refuse(c, __func__); }

// A step has ended when fmi2DoStep returns, so that nothing is ever pending.
fmi2Status fmi2GetStatus(fmi2Component, const fmi2StatusKind, fmi2Status*) { return fmi2Discard; }
fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Real* value) {
  if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
  return guarded(c, any, __func__, [&](Instance& i) { *value = i.time(); });
}
fmi2Status fmi2GetIntegerStatus(fmi2Component, const fmi2StatusKind, fmi2Integer*) { return fmi2Discard; }
fmi2Status fmi2GetBooleanStatus(fmi2Component, const fmi2StatusKind kind, fmi2Boolean* value) {
  if (kind != fmi2Terminated) return fmi2Discard;
  *value = fmi2False;
  return fmi2OK;
}
fmi2Status fmi2GetStringStatus(fmi2Component, const fmi2StatusKind, fmi2String*) { return fmi2Discard; }
