// The one export macro. The libraries are built with hidden visibility; what outside code, tests and compiled shaders
// use is marked with it. It stays "default" for users too, so that exceptions and RTTI match across shared objects.
#pragma once

#define DRYDOCK_API __attribute__((visibility("default")))

/** On a function of the engine that is absent here: calling it is a compile error with these words. */
#define DRYDOCK_ABSENT(Name, WayRound) __attribute__((unavailable("drydock does not have " #Name ": " WayRound)))
