// FScopeLock: holds a critical section for a scope. Source: engine Misc/ScopeLock.h.
#pragma once

#include "HAL/CriticalSection.h"
#include "Misc/AssertionMacros.h"
#include "Templates/UnrealTemplate.h"

class FScopeLock : private FNoncopyable
{
public:
	explicit FScopeLock(FCriticalSection* InSection)
		: Section(InSection)
	{
		check(Section != nullptr);
		Section->Lock();
	}
	~FScopeLock() { Unlock(); }

	/** Before the end of the scope. */
	void Unlock()
	{
		if (Section != nullptr)
		{
			Section->Unlock();
			Section = nullptr;
		}
	}

private:
	FCriticalSection* Section;
};
