// Keeps what draws and dispatches computed, for frames in which everything that decides their results is the same.
#pragma once

#include "BoundShader.h"
#include "RHITexture.h"
#include "TexelBlock.h"

#include <list>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** Results by a hash of all that decides them: the shader, its constants, samplers and interpolants, the threads, the
 * contents of what it reads, and the contents before of what it does not overwrite as a whole. A result is all texels
 * and bytes that the shader may have written. Results that no frame used for a while go, those that were not used for
 * the longest time first. Not for two threads at once. */
class DRYDOCK_API FReuseCache : private FNoncopyable
{
public:
	static constexpr uint64 DefaultBytes = uint64(1) << 30;
	/** A result goes when so many frames have not used it: a hand that drags leaves one in each frame. */
	static constexpr uint64 KeptFrames = 32;

	/** Results take at most so much memory. */
	explicit FReuseCache(uint64 InMaxBytes = DefaultBytes)
		: MaxBytes(InMaxBytes)
	{
	}

	/** A frame begins. Results that the frames before used or made may go where memory is needed. */
	void BeginFrame();

	uint64 GetBytes() const { return Bytes; }
	size_t GetNumResults() const { return Results.size(); }

private:
	friend class FDispatchReuse;

	struct FResult
	{
		FMemoryHash Key;
		FResourceMemory Written; // all outputs, one behind the other
		uint64 NumBytes = 0;
		std::vector<FMemoryHash> MipsAfter; // of each output
		uint64 Taps = 0;
		bool bFellBack = false;
		uint64 LastFrame = 0;
	};

	void RemoveOldest();
	/** Null: it is not there. */
	FResult* Find(const FMemoryHash& Key);
	/** Null: there is no room beside the results of this frame. */
	FResult* Add(const FMemoryHash& Key, uint64 NumBytes);

	const uint64 MaxBytes;
	uint64 Bytes = 0;
	uint64 Frame = 1;
	std::list<FResult> Results; // the last used first
	std::map<FMemoryHash, std::list<FResult>::iterator> ByKey;
};

/** The cache in scope; null: everything runs. */
DRYDOCK_API FReuseCache* GetReuseCache();

/** During its scope draws and dispatches use the cache; null: none. */
class DRYDOCK_API FScopedReuse : private FNoncopyable
{
public:
	explicit FScopedReuse(FReuseCache* Cache);
	~FScopedReuse();

private:
	FReuseCache* const Before;
};

/** One draw or dispatch: takes its result from the cache in scope, or keeps it there. */
class DRYDOCK_API FDispatchReuse : private FNoncopyable
{
public:
	/** Targets: the textures of Args.Targets; null, or a shorter list: nothing is written there. */
	FDispatchReuse(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole,
		const std::vector<FRHITexture*>& Targets);

	struct FRun
	{
		uint64 Taps = 0;        // as measured
		bool bFellBack = false; // a hand-written kernel ran its shader
	};

	/** Puts the kept result where the work would have written it. Empty: it has to be done. */
	std::optional<FRun> Take();
	/** It is done. */
	void Keep(const FRun& Run);

	/** Why nothing is taken or kept, for people to read; empty: it may be, or there is no cache. */
	const std::string& GetWhyNot() const { return WhyNot; }

private:
	/** Memory that is written; Texture: it is of this mip and plane. */
	struct FOutput
	{
		FTexelBlock Block;
		FRHITexture* Texture = nullptr;
		int32 Mip = 0;
		int32 Plane = 0;
	};

	void FindOutputs(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole,
		const std::vector<FRHITexture*>& Targets);
	void AddMip(const FKernelMip& Mip, size_t TexelBytes, const FIntRect& Rect, FRHITexture* Texture);
	void FindKey(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole,
		const std::vector<FRHITexture*>& Targets);

	FReuseCache* const Cache = GetReuseCache();
	FMemoryHash Key; // not known: nothing is taken and nothing kept
	std::vector<FOutput> Outputs;
	std::string WhyNot;
	bool bForeignOutput = false; // one whose texture is not known
};

} // namespace Drydock
