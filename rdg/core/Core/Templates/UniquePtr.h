// TUniquePtr: the one owner of an object, over std::unique_ptr. Source: engine Templates/UniquePtr.h.
#pragma once

#include "Misc/AssertionMacros.h"

#include <memory>

template<typename T, typename Deleter = std::default_delete<T>>
class TUniquePtr
{
	template<typename U, typename OtherDeleter>
	friend class TUniquePtr;

public:
	using ElementType = std::remove_extent_t<T>;

	TUniquePtr() = default;
	TUniquePtr(std::nullptr_t) {}
	explicit TUniquePtr(ElementType* Pointer)
		: Data(Pointer)
	{
	}
	template<typename U, typename OtherDeleter>
	requires std::is_convertible_v<U*, T*> TUniquePtr(TUniquePtr<U, OtherDeleter>&& Other)
		: Data(std::move(Other.Data))
	{
	}

	bool IsValid() const { return Data != nullptr; }
	explicit operator bool() const { return IsValid(); }
	ElementType* Get() const { return Data.get(); }
	ElementType* Release() { return Data.release(); }
	void Reset(ElementType* Pointer = nullptr) { Data.reset(Pointer); }
	ElementType* operator->() const
	{
		checkSlow(IsValid());
		return Data.get();
	}
	ElementType& operator*() const
	{
		checkSlow(IsValid());
		return *Data.get();
	}
	ElementType& operator[](SIZE_T Index) const requires std::is_array_v<T> { return Data[Index]; }

	friend bool operator==(const TUniquePtr& A, const TUniquePtr& B) { return A.Data == B.Data; }
	friend bool operator==(const TUniquePtr& A, std::nullptr_t) { return !A.IsValid(); }

private:
	std::unique_ptr<T, Deleter> Data;
};

template<typename T, typename... ArgumentTypes>
requires(!std::is_array_v<T>) TUniquePtr<T> MakeUnique(ArgumentTypes&&... Arguments)
{
	return TUniquePtr<T>(new T(std::forward<ArgumentTypes>(Arguments)...));
}

/** A zeroed array. */
template<typename T>
requires std::is_unbounded_array_v<T> TUniquePtr<T> MakeUnique(SIZE_T Count)
{
	return TUniquePtr<T>(new std::remove_extent_t<T>[Count]());
}
