// Carries the precompiled header (cmake/precompiled.hpp); has nothing of its own.
