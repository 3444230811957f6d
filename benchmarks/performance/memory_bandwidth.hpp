// How fast the machine moves bytes.
#pragma once

namespace moat::performance {

/// Copies arrays much larger than the caches on one thread: seconds per byte, every byte read and every byte written
/// counted once. One pass, so that it can take turns with what it is compared with; the first call warms up.
double seconds_per_byte_copied();

}  // namespace moat::performance
