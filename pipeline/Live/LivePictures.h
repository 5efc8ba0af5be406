// The finished pictures of a session, for every thread that is asked for one.
#pragma once

#include "Run/RunResult.h"

#include <atomic>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace Drydock
{

/** A final picture. */
struct FLivePicture
{
	uint64_t Revision = 0;
	FPicture Final;
	std::string Codes; // rows from the top, RGBA of 8 bits: what final.png holds, and 255
	int Step = 1;
	std::string Small; // ShrinkCodes of Step; empty where that is 1
};

/** The codes of a smaller picture: means of Step x Step texels, of fewer at the right and at the bottom. Step: up
 * to 16.
 */
DRYDOCK_API std::string ShrinkCodes(const FLivePicture& Picture, int Step);

/** Bytes of 32-bit floats, RGBA, rows from the top. Alpha is 1 where the picture has none. bAsFile: the numbers that
 * WriteExr writes, which are half floats where they fit. */
DRYDOCK_API std::string MakeFloatBytes(const FPicture& Picture, bool bAsFile);

/** Every function from any thread. */
class DRYDOCK_API FLivePictures
{
public:
	using FHandle = std::shared_ptr<const FLivePicture>;

	/** Makes the newest, by all threads; for one caller at a time. The first one is the start's. */
	void Add(uint64_t Revision, const FRunResult& Result);

	/** The step for which the next pictures have small ones. */
	void SetStep(int InStep) { Step = InStep; }

	/** Keeps the newest under a name. */
	void Keep(const std::string& Name);
	void Forget(const std::string& Name);

	/** "now", "start", a name that was kept, or a revision, of which the last few are here. Null: there is none. */
	FHandle Find(const std::string& Name) const;

private:
	mutable std::recursive_mutex Mutex; // pictures end in its scope
	std::string Spare;                  // the bytes of the last picture that ended
	std::deque<FHandle> Last;           // the newest first
	std::atomic<int> Step = 1;
	std::map<std::string, FHandle> Kept;
};

} // namespace Drydock
