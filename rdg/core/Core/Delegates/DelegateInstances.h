// Defines what a delegate holds: the bound call, the object it belongs to and whether that still lives. Source: engine
// Delegates/IDelegateInstance.h.
#pragma once

#include "Templates/Function.h"
#include "Templates/SharedPointer.h"
#include "UObject/UObjectBase.h"

/** Names one binding; never used twice in a process. */
class FDelegateHandle
{
public:
	enum EGenerateNewHandleType
	{
		GenerateNewHandle
	};

	FDelegateHandle() = default;
	explicit FDelegateHandle(EGenerateNewHandleType)
		: Id(GenerateId())
	{
	}

	bool IsValid() const { return Id != 0; }
	void Reset() { Id = 0; }
	bool operator==(const FDelegateHandle&) const = default;
	friend uint32 GetTypeHash(const FDelegateHandle& Handle) { return ::GetTypeHash(Handle.Id); }

private:
	DRYDOCK_API static uint64 GenerateId();

	uint64 Id = 0;
};

namespace Drydock::Private
{

/** Whether the object of a binding still lives; unset: it always does. */
using FLifeWatch = std::function<bool()>;

/** Watches a UObject; any other type must outlive the binding. */
template<typename ObjectType>
FLifeWatch WatchObject(const ObjectType* Object)
{
	if constexpr (std::is_base_of_v<UObjectBase, ObjectType>)
	{
		return [Weak = Object != nullptr ? Object->GetLifeToken() : std::weak_ptr<const void>()]
		{
			return !Weak.expired();
		};
	}
	else
	{
		return nullptr;
	}
}

template<typename ReturnType, typename... ArgumentTypes>
class TDelegateInstance
{
public:
	TDelegateInstance(
		const void* InObject, FLifeWatch&& InWatch, TUniqueFunction<ReturnType(ArgumentTypes...)>&& InCall)
		: Object(InObject)
		, Watch(std::move(InWatch))
		, Call(std::move(InCall))
		, Handle(FDelegateHandle::GenerateNewHandle)
	{
	}

	bool IsAlive() const { return !Watch || Watch(); }
	const void* GetObject() const { return Object; }
	FDelegateHandle GetHandle() const { return Handle; }
	ReturnType Execute(ArgumentTypes... Arguments) const { return Call(std::forward<ArgumentTypes>(Arguments)...); }

private:
	const void* Object;
	FLifeWatch Watch;
	TUniqueFunction<ReturnType(ArgumentTypes...)> Call;
	FDelegateHandle Handle;
};

} // namespace Drydock::Private
