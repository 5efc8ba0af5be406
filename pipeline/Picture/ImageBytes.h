// Reads an image file from memory, for callers that read thousands a second.
#pragma once

#include "DrydockAPI.h"
#include "Templates/UnrealTemplate.h"

#include <string>

namespace Drydock
{

/** While it lives, an FImageFile of this name that this thread makes reads these bytes, and no file. One at a time. */
class DRYDOCK_API FImageBytes : private FNoncopyable
{
public:
	FImageBytes(const std::string& InName, const std::string& InBytes);
	~FImageBytes();

	/** Null where the thread has none of this name. */
	static const std::string* Find(const std::string& Name);

private:
	const std::string Name;
	const std::string& Bytes;
};

} // namespace Drydock
