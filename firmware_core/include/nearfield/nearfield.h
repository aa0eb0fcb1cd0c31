/* Nearfield from C: clearances of points to a field image, Q4.27 fixed point (Fixed<27>: metres * 2^27).
   Semantics, statuses and rounding are those of nearfield/query/clearance.hpp. No allocation, no hidden state. */
#ifndef NEARFIELD_NEARFIELD_H
#define NEARFIELD_NEARFIELD_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A loaded field. Filled in by nearfield_load(); its contents are not part of the interface. It refers to the image,
   which must stay where it is, unchanged. All zero: no field; every query to it answers NEARFIELD_INVALID. */
typedef struct nearfield_field {
  uint32_t state[32];
} nearfield_field;

/* A pose for a slot: rotation by rows in Q2.30, translation in Q4.27 metres. */
typedef struct nearfield_pose {
  int32_t rotation[9];
  int32_t translation[3];
} nearfield_pose;

enum { NEARFIELD_SLOT_LIMIT = 16 }; /* poses that a query takes; fields with more slots answer invalid */

enum { NEARFIELD_INVALID = 0, NEARFIELD_TOUCHING = 1, NEARFIELD_UNDECIDED = 2, NEARFIELD_CLEAR = 3 };

typedef struct nearfield_clearance {
  int32_t status;       /* one of the above; only NEARFIELD_CLEAR permits anything */
  int32_t distance;     /* Q4.27 metres, never too large; the least number if invalid */
  int32_t direction[3]; /* Q4.27, away */
} nearfield_clearance;

/* Checks an image in place. Returns 0, or the number of the LoadStatus (nearfield/field/image.hpp) that says why not. */
int nearfield_load(nearfield_field* field, const void* image, size_t byte_count);

/* Worst-case instructions of one nearfield_clearance_at() on a Cortex-M4, 0 for no field. */
uint32_t nearfield_budget(const nearfield_field* field);

/* Clearance of a point (Q4.27 metres, at most 4 m in each coordinate). `slots` may be null if the field has none. */
nearfield_clearance nearfield_clearance_at(const nearfield_field* field, const int32_t point[3],
                                           const nearfield_pose* slots, uint32_t slot_count);

#ifdef __cplusplus
}
#endif

#endif
