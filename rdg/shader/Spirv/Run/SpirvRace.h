// Finds data races of the threads of a group: two threads access one number of groupshared memory, one of them writes,
// and no barrier is between them.
#pragma once

#include "SpirvProgram.h"

#include <set>
#include <tuple>
#include <vector>

namespace Drydock
{

enum class ESharedAccess : uint8_t
{
	Read,
	Write,
	Atomic
};

/** An access, and one of another thread that came before it here and may come behind it elsewhere. Threads:
 * SV_GroupIndex; Word: counted from the first of groupshared memory. */
struct FSpirvRace
{
	const FSpirvStep* Step = nullptr;
	const FSpirvStep* Before = nullptr;
	uint32_t Thread = 0;
	uint32_t ThreadBefore = 0;
	uint32_t Word = 0;
	ESharedAccess Access = ESharedAccess::Read;
	ESharedAccess AccessBefore = ESharedAccess::Read;
};

/** A number of groupshared memory that a thread read, and who had put it there. */
struct FSharedRead
{
	const FSpirvStep* Step = nullptr;
	uint32_t Thread = 0;                // SV_GroupIndex of the one that wrote
	const FSpirvStep* Writer = nullptr; // null: nothing wrote it
};

class DRYDOCK_API FRaceFinder
{
public:
	/** A group begins. */
	void Begin(size_t NumWords);
	/** From now on the reads of one thread are kept, in its order. */
	void Follow(uint32_t Thread) { Followed = Thread; }
	const std::vector<FSharedRead>& GetFollowed() const { return Reads; }
	/** All threads of it have come to a barrier. */
	void PassBarrier() { ++Epoch; }
	/** Value: the value written. Two threads that write the same value to one place are not a race. */
	void Touch(uint32_t Thread, uint32_t Word, const FSpirvStep& Step, ESharedAccess Access, uint64_t Value);
	/** Races of the group: each pair of places once for a thread. */
	const std::vector<FSpirvRace>& GetRaces() const { return Races; }

private:
	struct FTouch
	{
		uint64_t Epoch = 0; // 0: never
		uint32_t Thread = 0;
		const FSpirvStep* Step = nullptr;
		uint64_t Value = 0;
	};
	/** The last one, and the last one of another thread. */
	struct FLastTwo
	{
		FTouch Touches[2];

		void Add(const FTouch& New)
		{
			if (Touches[0].Epoch == New.Epoch && Touches[0].Thread != New.Thread)
			{
				Touches[1] = Touches[0];
			}
			Touches[0] = New;
		}
	};
	struct FWord
	{
		FTouch Writer;
		FLastTwo Changers; // by atomic operations
		FLastTwo Readers;
	};

	std::vector<FWord> Words;
	std::vector<FSharedRead> Reads;
	uint32_t Followed = ~0u;
	std::vector<FSpirvRace> Races;
	std::set<std::tuple<const FSpirvStep*, const FSpirvStep*, uint32_t>> Known;
	uint64_t Epoch = 1;
};

/** "a read of Sums[3], which thread (5, 0) writes in line 41: no barrier is between" */
DRYDOCK_API std::string DescribeRace(
	const FSpirvProgram& Program, const FSpirvRace& Race, const std::string& ThreadBefore);

} // namespace Drydock
