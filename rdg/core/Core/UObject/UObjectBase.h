// UObjectBase: the part of an object by which weak pointers and delegates notice its end. There is no garbage
// collection and no reflection: objects live as C++ says. Source: engine UObject/UObjectBase.h.
#pragma once

#include "CoreTypes.h"

#include <memory>

class DRYDOCK_API UObjectBase
{
public:
	UObjectBase() = default;
	virtual ~UObjectBase() = default;
	// A copy is another object with a life of its own.
	UObjectBase(const UObjectBase&) {}
	UObjectBase& operator=(const UObjectBase&) { return *this; }

	/** Expires when this object is destroyed. */
	std::weak_ptr<const void> GetLifeToken() const { return LifeToken; }

private:
	std::shared_ptr<const void> LifeToken = std::make_shared<char>();
};
