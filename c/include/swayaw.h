/* Ships for other languages: C99, one handle, quantities by name. docs/c_interface.md

       swayaw_ship* ship = swayaw_open("kvlcc2.toml", 0.0);
       swayaw_set(ship, "delta_order_rad", -0.35);
       while (running) swayaw_step(ship, 0.02);
       swayaw_close(ship);

   SI and radians, axes and signs of docs/notation.md; a rudder angle is positive to port. What returns an int returns
   0, or -1 where it could not be done, and swayaw_error() says why in one line. A ship is for one thread at a time. */
#ifndef SWAYAW_H
#define SWAYAW_H

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)
typedef struct swayaw_ship swayaw_ship; /* under way: the Simulator of swayaw/nonlinear/simulator.hpp */

/* What went wrong with the last call on this thread, in one line; "" if nothing did. Valid until the next call. */
const char* swayaw_error(void);

/* A ship from a file, or where no such file is there, the published ship of that bare name: at the origin on heading 0,
   straight ahead with the propulsion that carries her at that speed [m/s]; 0 for the service speed. NULL where there is
   no such ship; a file that is wrong is named with line and column. */
swayaw_ship* swayaw_open(const char* ship, double speed);
void swayaw_close(swayaw_ship* ship); /* NULL is fine */

/* Goes on by dt [s], more than 0. Fails where the motion grew without bound and was not followed. */
int swayaw_step(swayaw_ship* ship, double dt);

/* Whether the force model holds where she is; else what carries it on (docs/simulation.md). */
const char* swayaw_why(const swayaw_ship* ship);

typedef enum {
  SWAYAW_STATE, /* of the ship; may be set, upon which heel and memory become those of a steady motion */
  SWAYAW_ORDER, /* held until it is set anew; to set what is held already changes nothing */
  SWAYAW_OUTPUT /* read only */
} swayaw_kind;

typedef struct {
  const char *name, *unit; /* the unit is "1" where there is none */
  swayaw_kind kind;
  const char* description;
} swayaw_quantity;

/* All quantities; the same for every ship, in the same order. NULL beyond the last. */
const swayaw_quantity* swayaw_quantity_at(int index);

/* By name; NaN where the ship does not have it. */
int swayaw_get(const swayaw_ship* ship, const char* name, double* value);
int swayaw_set(swayaw_ship* ship, const char* name, double value);

/* A zigzag; what was not reached is NaN. Source of the indices: IMO resolution MSC.137(76) */
typedef struct {
  double reversal_s[4];    /* when the heading reaches the switch angle */
  double overshoot_rad[4]; /* heading peak beyond it */
  double period_s;         /* of the last full cycle */
} swayaw_zigzag_indices;

/* Rudder put to `rudder` and reversed at `heading`, both positive; to port first if `port_first`. Ship and speed as in
   swayaw_open. */
int swayaw_zigzag(const char* ship, double speed, double rudder, double heading, int port_first,
                  swayaw_zigzag_indices* indices);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
