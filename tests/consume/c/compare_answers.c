/* Loads a field image through the C interface and compares its answers, to the bit, with those that C++
   wrote: compare_answers IMAGE ANSWERS. */
#include <nearfield/nearfield.h>

#include <stdio.h>
#include <string.h>

static uint32_t words[1024];

static size_t read_image(const char* file) {
  FILE* from = fopen(file, "rb");
  size_t size;
  if (from == NULL) return 0;
  size = fread(words, 1, sizeof words, from);
  fclose(from);
  return size;
}

/* The pose of write_answers.cpp: a quarter turn about z, 0.75 m along x. */
static nearfield_pose slot_pose(void) {
  const int32_t one = (int32_t)1 << 30;
  nearfield_pose pose;
  memset(&pose, 0, sizeof pose);
  pose.rotation[1] = -one;
  pose.rotation[3] = one;
  pose.rotation[8] = one;
  pose.translation[0] = 3 * ((int32_t)1 << 25);
  return pose;
}

int main(int count, char** arguments) {
  nearfield_field field, none;
  nearfield_pose pose = slot_pose();
  const int32_t origin[3] = {0, 0, 0};
  int32_t point[3], status, distance, direction[3];
  int compared = 0, clear = 0, touching = 0, invalid = 0;
  size_t size;
  FILE* answers;
  if (count != 3) return 2;
  size = read_image(arguments[1]);
  if (size == 0 || nearfield_load(&field, words, size) != 0 || nearfield_budget(&field) == 0) {
    fprintf(stderr, "the image of %lu bytes does not load\n", (unsigned long)size);
    return 1;
  }
  answers = fopen(arguments[2], "r");
  if (answers == NULL) return 1;
  while (fscanf(answers, "%d %d %d %d %d %d %d %d", &point[0], &point[1], &point[2], &status, &distance,
                &direction[0], &direction[1], &direction[2]) == 8) {
    const nearfield_clearance c = nearfield_clearance_at(&field, point, &pose, 1);
    if (c.status != status || c.distance != distance ||
        memcmp(c.direction, direction, sizeof direction) != 0) {
      fprintf(stderr, "at %d %d %d: status %d, distance %d; in C++ %d, %d\n", point[0], point[1], point[2],
              c.status, c.distance, status, distance);
      return 1;
    }
    ++compared;
    clear += c.status == NEARFIELD_CLEAR;
    touching += c.status == NEARFIELD_TOUCHING;
    invalid += c.status == NEARFIELD_INVALID;
  }
  fclose(answers);
  printf("%d answers are the same in C and C++: %d clear, %d touching, %d invalid\n", compared, clear,
         touching, invalid);
  if (compared != 121 || clear == 0 || touching == 0 || invalid == 0) return 1;

  /* What is missing or damaged answers invalid. */
  memset(&none, 0, sizeof none);
  if (nearfield_clearance_at(&none, origin, &pose, 1).status != NEARFIELD_INVALID) return 1;
  if (nearfield_clearance_at(&field, origin, NULL, 0).status != NEARFIELD_INVALID) return 1;
  if (nearfield_budget(&none) != 0) return 1;
  words[size / sizeof words[0] - 1] ^= 1;
  if (nearfield_load(&none, words, size) == 0) return 1;
  if (nearfield_clearance_at(&none, origin, &pose, 1).status != NEARFIELD_INVALID) return 1;
  return 0;
}
