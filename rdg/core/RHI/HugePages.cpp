// Huge pages by madvise, which Linux has.
#include "HugePages.h"

#include <sys/mman.h>

namespace Drydock
{

void AskForHugePages(void* Memory, size_t Bytes)
{
	constexpr uintptr_t PageBytes = 2 << 20;
	const uintptr_t Begin = (reinterpret_cast<uintptr_t>(Memory) + PageBytes - 1) / PageBytes * PageBytes;
	const uintptr_t End = (reinterpret_cast<uintptr_t>(Memory) + Bytes) / PageBytes * PageBytes;
	if (Begin < End)
	{
		madvise(reinterpret_cast<void*>(Begin), End - Begin, MADV_HUGEPAGE);
	}
}

} // namespace Drydock
