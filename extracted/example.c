#include <nearfield/nearfield.h>

static nearfield_field field; /* all zero: no field; every answer is invalid */

int start(const void* image, size_t byte_count) { return nearfield_load(&field, image, byte_count); }

int may_move(const int32_t tool[3]) { /* Q4.27 metres */
  const nearfield_clearance c = nearfield_clearance_at(&field, tool, NULL, 0);
  return c.status == NEARFIELD_CLEAR && c.distance > (1 << 27) / 50; /* 2 cm */
}
