// Intrusive reference counting: TRefCountPtr calls AddRef and Release of what it points to. Counts are atomic.
// Source: engine Templates/RefCounting.h.
#pragma once

#include "Misc/AssertionMacros.h"
#include "Templates/TypeHash.h"
#include "Templates/UnrealTemplate.h"

#include <atomic>

/** Interface of what other code counts. */
class DRYDOCK_API IRefCountedObject
{
public:
	virtual ~IRefCountedObject() = default;
	virtual uint32 AddRef() const = 0;
	virtual uint32 Release() const = 0;
	virtual uint32 GetRefCount() const = 0;
};

/** Counts references from 0 on and deletes itself when the last one goes. Not copied. */
class DRYDOCK_API FRefCountBase
{
public:
	FRefCountBase() = default;
	virtual ~FRefCountBase() = default;
	FRefCountBase(const FRefCountBase&) = delete;
	FRefCountBase& operator=(const FRefCountBase&) = delete;

	uint32 AddRef() const { return NumReferences.fetch_add(1, std::memory_order_relaxed) + 1; }
	uint32 Release() const
	{
		const uint32 Before = NumReferences.fetch_sub(1, std::memory_order_acq_rel);
		checkSlow(Before > 0);
		if (Before == 1)
		{
			delete this;
		}
		return Before - 1;
	}
	uint32 GetRefCount() const { return NumReferences.load(std::memory_order_relaxed); }

private:
	mutable std::atomic<uint32> NumReferences{0};
};

using FRefCountedObject = FRefCountBase;
using FThreadSafeRefCountedObject = FRefCountBase;

template<typename ReferencedType>
class TRefCountPtr
{
	template<typename OtherType>
	friend class TRefCountPtr;

public:
	using ElementType = ReferencedType;
	using ReferenceType = ReferencedType*;

	TRefCountPtr() = default;
	TRefCountPtr(std::nullptr_t) {}
	/** bAddRef false takes over a reference that the caller owns. */
	TRefCountPtr(ReferencedType* InReference, bool bAddRef = true)
		: Reference(InReference)
	{
		if (Reference != nullptr && bAddRef)
		{
			Reference->AddRef();
		}
	}
	TRefCountPtr(const TRefCountPtr& Other)
		: TRefCountPtr(Other.Reference)
	{
	}
	TRefCountPtr(TRefCountPtr&& Other) noexcept
		: Reference(std::exchange(Other.Reference, nullptr))
	{
	}
	template<typename OtherType>
	requires std::is_convertible_v<OtherType*, ReferencedType*> TRefCountPtr(const TRefCountPtr<OtherType>& Other)
		: TRefCountPtr(static_cast<ReferencedType*>(Other.Reference))
	{
	}
	template<typename OtherType>
	requires std::is_convertible_v<OtherType*, ReferencedType*> TRefCountPtr(TRefCountPtr<OtherType>&& Other)
	noexcept
		: Reference(std::exchange(Other.Reference, nullptr))
	{
	}
	~TRefCountPtr()
	{
		if (Reference != nullptr)
		{
			Reference->Release();
		}
	}

	// By value: copying and swapping is right for self-assignment and for releasing the last owner of Other.
	TRefCountPtr& operator=(TRefCountPtr Other) noexcept
	{
		std::swap(Reference, Other.Reference);
		return *this;
	}

	bool IsValid() const { return Reference != nullptr; }
	ReferencedType* GetReference() const { return Reference; }
	ReferencedType* Get() const { return Reference; }
	ReferencedType* operator->() const { return Reference; }
	operator ReferencedType*() const { return Reference; }
	uint32 GetRefCount() const { return Reference != nullptr ? Reference->GetRefCount() : 0; }
	void SafeRelease() { *this = nullptr; }
	void Swap(TRefCountPtr& Other) { std::swap(Reference, Other.Reference); }

	friend bool operator==(const TRefCountPtr& A, const TRefCountPtr& B) { return A.Reference == B.Reference; }
	friend bool operator==(const TRefCountPtr& A, const ReferencedType* B) { return A.Reference == B; }
	friend bool operator==(const TRefCountPtr& A, ReferencedType* B) requires(!std::is_const_v<ReferencedType>)
	{
		return A.Reference == B;
	}
	friend bool operator==(const TRefCountPtr& A, std::nullptr_t) { return A.Reference == nullptr; }

private:
	ReferencedType* Reference = nullptr;
};

template<typename T>
uint32 GetTypeHash(const TRefCountPtr<T>& Pointer)
{
	return GetTypeHash(Pointer.GetReference());
}

template<typename T, typename... ArgumentTypes>
TRefCountPtr<T> MakeRefCount(ArgumentTypes&&... Arguments)
{
	return TRefCountPtr<T>(new T(std::forward<ArgumentTypes>(Arguments)...));
}
