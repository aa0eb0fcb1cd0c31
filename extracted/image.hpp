// `image`: aligned to 4 bytes, in flash or RAM. It is checked and evaluated where it lies; nothing is copied.
inline nf::Clearance<Q> clearance_in_image(const void* image, size_t byte_count, const nf::Vector3<Q>& p) {
  const nf::Program<Q> field = nf::load<Q>(image, byte_count);   // once, at start-up
  if (field.status() != nf::LoadStatus::ok) return {};           // says why; a query would answer `invalid`
  return nf::clearance(field, p);                                // no further check of the image
}
