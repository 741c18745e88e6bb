# hexagait::hexagait is all of the library; find_package(hexagait) brings it back after an install.

