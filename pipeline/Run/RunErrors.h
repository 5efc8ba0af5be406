// The numbers of the messages about the passes of a run. A number never changes its meaning; docs/errors.md explains
// each one.
#pragma once

namespace Drydock
{

enum ERunError
{
	NoteSilentPass = 4004, // a pass wrote again what it read
};

} // namespace Drydock
