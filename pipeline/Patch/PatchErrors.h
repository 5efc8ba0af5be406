// The numbers of the messages of `drydock new`. docs/errors.md explains each one.
#pragma once

namespace Drydock
{

enum EPatchError
{
	ErrorPatchName = 1060,   // a name that no patch can have
	ErrorPatchExists = 1061, // something of that name is there already
};

} // namespace Drydock
