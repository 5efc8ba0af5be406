// A file descriptor that is closed with its scope, and a write that is checked to the end.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <utility>

namespace Drydock
{

class DRYDOCK_API FFileDescriptor
{
public:
	FFileDescriptor() = default;
	explicit FFileDescriptor(int InValue)
		: Value(InValue)
	{
	}
	FFileDescriptor(FFileDescriptor&& Other) noexcept
		: Value(std::exchange(Other.Value, -1))
	{
	}
	FFileDescriptor& operator=(FFileDescriptor&& Other) noexcept
	{
		std::swap(Value, Other.Value);
		return *this;
	}
	~FFileDescriptor() { Close(); }

	explicit operator bool() const { return Value >= 0; }
	int Get() const { return Value; }

	/** 0, or the error that a file system kept back until now. */
	int Close();

private:
	int Value = -1; // -1: none
};

/** Writes all Bytes. 0, or the error that ended it. */
DRYDOCK_API int WriteAll(const FFileDescriptor& File, const std::string& Bytes);

/** Writes all Bytes and closes. 0, or the error of the first step that failed. */
DRYDOCK_API int WriteAndClose(FFileDescriptor File, const std::string& Bytes);

/** Reads from here to the end; OutError is 0, or the reason why the result is incomplete. */
DRYDOCK_API std::string ReadToEnd(const FFileDescriptor& File, int& OutError);

/** "No space left on device", whatever thread asks. */
DRYDOCK_API std::string DescribeSystemError(int Error);

} // namespace Drydock
