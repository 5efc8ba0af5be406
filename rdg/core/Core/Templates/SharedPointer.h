// TSharedPtr, TSharedRef, TWeakPtr and TSharedFromThis over std::shared_ptr. The mode is kept as part of the type, as
// in the engine, but counting is thread-safe in both. Source: engine Templates/SharedPointer.h.
#pragma once

#include "Misc/AssertionMacros.h"
#include "Templates/TypeHash.h"
#include "Templates/UnrealTemplate.h"

#include <memory>

enum class ESPMode : uint8
{
	NotThreadSafe = 0,
	ThreadSafe = 1,
};

template<typename T, ESPMode Mode = ESPMode::ThreadSafe>
class TSharedPtr;
template<typename T, ESPMode Mode = ESPMode::ThreadSafe>
class TSharedRef;
template<typename T, ESPMode Mode = ESPMode::ThreadSafe>
class TWeakPtr;

namespace Drydock::Private
{

/** The result of MakeShareable: a pointer on its way to its first owner. */
template<typename T>
struct TRawPtrProxy
{
	std::shared_ptr<T> Pointer;
};

} // namespace Drydock::Private

/** A shared pointer that is never null. */
template<typename T, ESPMode Mode>
class TSharedRef
{
public:
	using ElementType = T;

	explicit TSharedRef(T* Pointer)
		: Data(Pointer)
	{
		CheckValid();
	}
	template<typename U>
	requires std::is_convertible_v<U*, T*> TSharedRef(const Drydock::Private::TRawPtrProxy<U>& Proxy)
		: Data(Proxy.Pointer)
	{
		CheckValid();
	}
	template<typename U>
	requires std::is_convertible_v<U*, T*> TSharedRef(const TSharedRef<U, Mode>& Other)
		: Data(Other.ToStdPtr())
	{
	}
	/** Ours: takes part in the ownership of a std::shared_ptr, which must not be null. */
	explicit TSharedRef(std::shared_ptr<T> Pointer)
		: Data(std::move(Pointer))
	{
		CheckValid();
	}
	// Copying in place of moving: a moved-from reference would be null.
	TSharedRef(const TSharedRef&) = default;
	TSharedRef& operator=(const TSharedRef&) = default;

	T& Get() const { return *Data; }
	T& operator*() const { return *Data; }
	T* operator->() const { return Data.get(); }
	TSharedPtr<T, Mode> ToSharedPtr() const { return TSharedPtr<T, Mode>(*this); }
	TWeakPtr<T, Mode> ToWeakPtr() const { return TWeakPtr<T, Mode>(*this); }
	int32 GetSharedReferenceCount() const { return static_cast<int32>(Data.use_count()); }
	bool IsUnique() const { return Data.use_count() == 1; }
	const std::shared_ptr<T>& ToStdPtr() const { return Data; }

private:
	void CheckValid() const { checkf(Data != nullptr, "A TSharedRef cannot be null"); }

	std::shared_ptr<T> Data;
};

template<typename T, ESPMode Mode>
class TSharedPtr
{
public:
	using ElementType = T;

	TSharedPtr() = default;
	TSharedPtr(std::nullptr_t) {}
	template<typename U>
	requires std::is_convertible_v<U*, T*>
	explicit TSharedPtr(U* Pointer)
		: Data(Pointer)
	{
	}
	template<typename U>
	requires std::is_convertible_v<U*, T*> TSharedPtr(const Drydock::Private::TRawPtrProxy<U>& Proxy)
		: Data(Proxy.Pointer)
	{
	}
	template<typename U>
	requires std::is_convertible_v<U*, T*> TSharedPtr(const TSharedPtr<U, Mode>& Other)
		: Data(Other.ToStdPtr())
	{
	}
	template<typename U>
	requires std::is_convertible_v<U*, T*> TSharedPtr(const TSharedRef<U, Mode>& Other)
		: Data(Other.ToStdPtr())
	{
	}
	/** Ours: takes part in the ownership of a std::shared_ptr. */
	explicit TSharedPtr(std::shared_ptr<T> Pointer)
		: Data(std::move(Pointer))
	{
	}

	bool IsValid() const { return Data != nullptr; }
	explicit operator bool() const { return IsValid(); }
	T* Get() const { return Data.get(); }
	T& operator*() const
	{
		check(IsValid());
		return *Data;
	}
	T* operator->() const
	{
		check(IsValid());
		return Data.get();
	}
	void Reset() { Data.reset(); }
	TSharedRef<T, Mode> ToSharedRef() const { return TSharedRef<T, Mode>(Data); }
	TWeakPtr<T, Mode> ToWeakPtr() const { return TWeakPtr<T, Mode>(*this); }
	int32 GetSharedReferenceCount() const { return static_cast<int32>(Data.use_count()); }
	bool IsUnique() const { return Data.use_count() == 1; }
	const std::shared_ptr<T>& ToStdPtr() const { return Data; }

private:
	std::shared_ptr<T> Data;
};

/** Watches an object without keeping it alive. */
template<typename T, ESPMode Mode>
class TWeakPtr
{
public:
	using ElementType = T;

	TWeakPtr() = default;
	TWeakPtr(std::nullptr_t) {}
	template<typename U>
	requires std::is_convertible_v<U*, T*> TWeakPtr(const TSharedPtr<U, Mode>& Pointer)
		: Data(Pointer.ToStdPtr())
	{
	}
	template<typename U>
	requires std::is_convertible_v<U*, T*> TWeakPtr(const TSharedRef<U, Mode>& Reference)
		: Data(Reference.ToStdPtr())
	{
	}
	/** Ours: watches what a std::weak_ptr watches. */
	explicit TWeakPtr(std::weak_ptr<T> Pointer)
		: Data(std::move(Pointer))
	{
	}

	bool IsValid() const { return !Data.expired(); }
	/** A null pointer if the object is gone. */
	TSharedPtr<T, Mode> Pin() const { return TSharedPtr<T, Mode>(Data.lock()); }
	void Reset() { Data.reset(); }

	friend bool operator==(const TWeakPtr& A, const TWeakPtr& B) { return A.Data.lock() == B.Data.lock(); }

private:
	std::weak_ptr<T> Data;
};

template<typename T, typename U, ESPMode Mode>
bool operator==(const TSharedPtr<T, Mode>& A, const TSharedPtr<U, Mode>& B)
{
	return A.Get() == B.Get();
}
template<typename T, ESPMode Mode>
bool operator==(const TSharedPtr<T, Mode>& A, std::nullptr_t)
{
	return !A.IsValid();
}
template<typename T, typename U, ESPMode Mode>
bool operator==(const TSharedRef<T, Mode>& A, const TSharedRef<U, Mode>& B)
{
	return &A.Get() == &B.Get();
}
template<typename T, typename U, ESPMode Mode>
bool operator==(const TSharedPtr<T, Mode>& A, const TSharedRef<U, Mode>& B)
{
	return A.Get() == &B.Get();
}

template<typename T, ESPMode Mode>
uint32 GetTypeHash(const TSharedPtr<T, Mode>& Pointer)
{
	return GetTypeHash(Pointer.Get());
}
template<typename T, ESPMode Mode>
uint32 GetTypeHash(const TSharedRef<T, Mode>& Reference)
{
	return GetTypeHash(&Reference.Get());
}

/** Gives an object that is owned by shared pointers a shared pointer to itself. */
template<typename T, ESPMode Mode = ESPMode::ThreadSafe>
class TSharedFromThis : public std::enable_shared_from_this<T>
{
public:
	/** The object must be owned already. */
	TSharedRef<T, Mode> AsShared() { return TSharedRef<T, Mode>(this->weak_from_this().lock()); }
	TSharedRef<const T, Mode> AsShared() const { return TSharedRef<const T, Mode>(this->weak_from_this().lock()); }
	TWeakPtr<T, Mode> AsWeak() { return TWeakPtr<T, Mode>(this->weak_from_this()); }
	TWeakPtr<const T, Mode> AsWeak() const { return TWeakPtr<const T, Mode>(this->weak_from_this()); }
	bool DoesSharedInstanceExist() const { return !this->weak_from_this().expired(); }

protected:
	template<typename U>
	static TSharedRef<U, Mode> SharedThis(U* ThisPointer)
	{
		return TSharedRef<U, Mode>(std::static_pointer_cast<U>(ThisPointer->shared_from_this()));
	}
};

template<typename T, ESPMode Mode = ESPMode::ThreadSafe, typename... ArgumentTypes>
TSharedRef<T, Mode> MakeShared(ArgumentTypes&&... Arguments)
{
	return TSharedRef<T, Mode>(std::make_shared<T>(std::forward<ArgumentTypes>(Arguments)...));
}

/** Hands a new object over to its first TSharedPtr or TSharedRef. */
template<typename T>
Drydock::Private::TRawPtrProxy<T> MakeShareable(T* Pointer)
{
	return {std::shared_ptr<T>(Pointer)};
}

template<typename T, typename DeleterType>
Drydock::Private::TRawPtrProxy<T> MakeShareable(T* Pointer, DeleterType&& Deleter)
{
	return {std::shared_ptr<T>(Pointer, std::forward<DeleterType>(Deleter))};
}

template<typename To, typename From, ESPMode Mode>
TSharedPtr<To, Mode> StaticCastSharedPtr(const TSharedPtr<From, Mode>& Pointer)
{
	return TSharedPtr<To, Mode>(std::static_pointer_cast<To>(Pointer.ToStdPtr()));
}
template<typename To, typename From, ESPMode Mode>
TSharedRef<To, Mode> StaticCastSharedRef(const TSharedRef<From, Mode>& Reference)
{
	return TSharedRef<To, Mode>(std::static_pointer_cast<To>(Reference.ToStdPtr()));
}
template<typename To, typename From, ESPMode Mode>
TSharedPtr<To, Mode> ConstCastSharedPtr(const TSharedPtr<From, Mode>& Pointer)
{
	return TSharedPtr<To, Mode>(std::const_pointer_cast<To>(Pointer.ToStdPtr()));
}
template<typename To, typename From, ESPMode Mode>
TSharedRef<To, Mode> ConstCastSharedRef(const TSharedRef<From, Mode>& Reference)
{
	return TSharedRef<To, Mode>(std::const_pointer_cast<To>(Reference.ToStdPtr()));
}
