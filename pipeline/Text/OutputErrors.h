// The numbers of the messages about folders of outputs; docs/errors.md explains each one.
#pragma once

namespace Drydock
{

enum EOutputError
{
	ErrorForeignContent = 1080, // something that drydock did not write is in the way

	ErrorFolderInUse = 5021, // another process writes to the folder
	ErrorListDamaged = 5023, // the list of what drydock wrote cannot be read
};

} // namespace Drydock
