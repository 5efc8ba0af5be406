// Requests to the process with glslang in it, and its answers: lengths, then bytes, over one socket.
#pragma once

#include <cerrno>
#include <cstdint>
#include <string>
#include <sys/socket.h>
#include <sys/types.h>
#include <vector>

namespace Drydock::FrontEnd
{

/** Followed by the entry point's name and the shader's text. */
struct FRequestHead
{
	uint32_t Stage; // EShaderStage
	uint32_t bKeepFunctions;
	uint32_t Seconds; // after which the process ends itself, should nobody be left to end it
	uint32_t EntrySize;
	uint32_t TextSize;
};

/** Followed by the messages, as glslangValidator prints them, and the words of SPIR-V. */
struct FReplyHead
{
	uint32_t bSucceeded;
	uint32_t OutputSize;
	uint32_t NumWords;
};

/** False when the other end is gone. */
inline bool Send(int Socket, const void* Bytes, size_t Size)
{
	for (size_t Done = 0; Done < Size;)
	{
		const ssize_t Count = send(Socket, static_cast<const char*>(Bytes) + Done, Size - Done, MSG_NOSIGNAL);
		if (Count < 0 && errno != EINTR)
		{
			return false;
		}
		Done += Count > 0 ? size_t(Count) : 0;
	}
	return true;
}

} // namespace Drydock::FrontEnd
