/* The C interface from C99.   swayaw_test_c SHIPS SCRATCH */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <swayaw.h>

static int failures = 0;

static void check(int true_, const char* law) {
  if (true_) return;
  ++failures;
  fprintf(stderr, "fails: %s   (%s)\n", law, swayaw_error());
}

static double value_of(const swayaw_ship* ship, const char* name) {
  double value = 0.0;
  check(swayaw_get(ship, name, &value) == 0, name);
  return value;
}

static int refused(int result, const char* words) { return result == -1 && strstr(swayaw_error(), words) != NULL; }

static const double degree = 3.14159265358979323846 / 180.0;

/* A 10/10 zigzag by the helm of this program at 50 Hz; the heading peaks beyond 10 deg, at most four. */
static int overshoots_at_the_helm(swayaw_ship* ship, double* overshoots) {
  const double step = 0.02, order = 10.0 * degree;
  double side = 1.0, peak = 0.0; /* of the turn: to starboard first */
  int reversals = 0, peaks = 0;
  check(swayaw_set(ship, "delta_order_rad", -order) == 0, "a rudder can be ordered");
  while (peaks < 4 && value_of(ship, "time_s") < 4000.0) {
    double heading;
    check(swayaw_step(ship, step) == 0, "a step can be made");
    heading = value_of(ship, "psi_rad");
    if (reversals > peaks) {
      /* the rudder is reversed; she still turns on */
      peak = fmax(peak, -side * heading);
      if (-side * heading < peak) overshoots[peaks++] = peak - order;
    }
    if (side * heading >= order) {
      ++reversals;
      peak = side * heading;
      side = -side;
      check(swayaw_set(ship, "delta_order_rad", -side * order) == 0, "a rudder can be reversed");
    }
  }
  return peaks;
}

static void zigzags_agree(const char* file) {
  double helm[4];
  swayaw_zigzag_indices indices;
  swayaw_ship* ship = swayaw_open(file, 0.0);
  int i;
  check(ship != NULL, "a ship is read from a file");
  if (ship == NULL) return;
  check(strcmp(swayaw_error(), "") == 0, "what succeeds leaves no trouble");
  check(swayaw_zigzag(file, 0.0, 10.0 * degree, 10.0 * degree, 0, &indices) == 0, "a zigzag has indices");
  check(overshoots_at_the_helm(ship, helm) == 4, "the helm of this program sails four overshoots");
  for (i = 0; i < 4; ++i) /* a helm at 50 Hz reverses up to 0.02 s late, at 0.3 deg/s */
    check(fabs(helm[i] - indices.overshoot_rad[i]) < 0.01 * degree, "overshoots are those of the zigzag");
  check(indices.reversal_s[1] > indices.reversal_s[0], "reversals follow each other");
  printf("overshoots %.2f, %.2f deg at the helm; %.2f, %.2f by the zigzag\n", helm[0] / degree, helm[1] / degree,
         indices.overshoot_rad[0] / degree, indices.overshoot_rad[1] / degree);
  swayaw_close(ship);
}

/* Two ships under opposite rudders: each goes her own way. */
static void ships_are_independent(const char* file) {
  swayaw_ship *a = swayaw_open(file, 0.0), *b = swayaw_open(file, 0.0);
  int i;
  swayaw_set(a, "delta_order_rad", 0.2), swayaw_set(b, "delta_order_rad", -0.2);
  for (i = 0; i < 1000; ++i) {
    swayaw_step(a, 0.05), swayaw_step(b, 0.05);
    swayaw_set(a, "delta_order_rad", 0.2); /* what is held already changes nothing */
  }
  check(value_of(a, "psi_rad") < -0.1 && value_of(b, "psi_rad") > 0.1, "rudder to port turns to port");
  swayaw_set(a, "current_speed_m_s", 1.0);
  check(fabs(value_of(a, "ug_m_s") - value_of(a, "u_m_s") - cos(value_of(a, "psi_rad"))) < 1e-12,
        "a current to the north adds its part along the ship");
  check(value_of(b, "current_speed_m_s") == 0.0, "the other ship has none");
  swayaw_close(a), swayaw_close(b);
}

static void every_quantity_can_be_read(const char* file) {
  swayaw_ship* ship = swayaw_open(file, 7.0);
  const swayaw_quantity* q;
  int count = 0;
  check(value_of(ship, "u_m_s") == 7.0, "she begins at the speed that is asked for");
  for (; (q = swayaw_quantity_at(count)) != NULL; ++count) {
    const double held = value_of(ship, q->name);
    if (q->kind == SWAYAW_OUTPUT) check(refused(swayaw_set(ship, q->name, 0.0), "can be read, not set"), q->name);
    else if (!isnan(held)) check(swayaw_set(ship, q->name, held) == 0, q->name);
    check(strlen(q->unit) > 0 && strlen(q->description) > 0, "a quantity tells its unit and what it is");
  }
  check(count > 20 && swayaw_quantity_at(-1) == NULL, "quantities end");
  check(strcmp(swayaw_why(ship), "the force model holds") == 0, "the force model holds straight ahead");
  swayaw_set(ship, "u_m_s", 0.0);
  check(strstr(swayaw_why(ship), "too little way") != NULL && value_of(ship, "validity") == 1.0, "at rest it does not");
  swayaw_close(ship);
}

static void trouble_is_told(const char* file, const char* scratch) {
  char bad[1024];
  FILE* out;
  double value;
  swayaw_zigzag_indices indices;
  swayaw_ship* ship = swayaw_open(file, 0.0);
  check(swayaw_open("no_such_ship", 0.0) == NULL && strstr(swayaw_error(), "kvlcc2") != NULL,
        "published ships are listed");
  check(swayaw_open("missing.toml", 0.0) == NULL && strstr(swayaw_error(), "missing.toml") != NULL,
        "the file is named");
  check(swayaw_open(NULL, 0.0) == NULL && strstr(swayaw_error(), "NULL") != NULL, "no name is refused");
  check(swayaw_open(file, -1.0) == NULL && strstr(swayaw_error(), "speed [m/s] must be positive") != NULL,
        "a speed astern is refused");
  snprintf(bad, sizeof bad, "%s/bad.toml", scratch);
  out = fopen(bad, "w");
  fputs("name = \"x\"\nmodel = \"mmg\"\n[hull]\nY_v = \"much\"\n", out), fclose(out);
  check(swayaw_open(bad, 0.0) == NULL && strstr(swayaw_error(), "bad.toml:") != NULL, "line and column are told");
  check(refused(swayaw_get(ship, "psi", &value), "no quantity \"psi\"; there are time_s x_m"), "names are listed");
  check(refused(swayaw_set(ship, "u_m_s", NAN), "finite"), "a state that is no number is refused");
  check(refused(swayaw_set(ship, "delta_order_rad", INFINITY), "finite"), "an endless order is refused");
  check(value_of(ship, "delta_order_rad") == 0.0, "what is refused changes nothing");
  check(refused(swayaw_step(ship, -1.0), "must be positive"), "time does not go back");
  check(refused(swayaw_step(NULL, 1.0), "the ship is NULL"), "no ship is refused");
  check(refused(swayaw_get(ship, "x_m", NULL), "NULL"), "no place is refused");
  check(refused(swayaw_zigzag(file, 0.0, 80.0 * degree, 0.1, 0, &indices), "80"),
        "a rudder beyond its stops is refused");
  swayaw_close(ship), swayaw_close(NULL);
}

int main(int count, char** arguments) {
  char file[1024];
  if (count != 3) return 2;
  snprintf(file, sizeof file, "%s/kvlcc2.toml", arguments[1]);
  zigzags_agree(file);
  ships_are_independent("kvlcc2");
  every_quantity_can_be_read(file);
  trouble_is_told(file, arguments[2]);
  return failures == 0 ? 0 : 1;
}
