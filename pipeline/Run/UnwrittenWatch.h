// Follows which texels of a frame's textures nothing has written, and finds the passes whose output depends on them.
#pragma once

#include "Diagnostics.h"
#include "DispatchObserver.h"
#include "Math/IntRect.h"
#include "PassCounters.h"

#include <map>
#include <set>
#include <string>
#include <vector>

class FRDGTexture;

namespace Drydock
{

/** Unwritten texels hold 0. A texture of one mip and one slice is followed from its first writer until all of it is
 * written. A draw leaves the texels outside its rect. A compute shader, or a pixel shader that discards, leaves the
 * texels in which a pattern stays that was put there before. If a pass reads a texture with such texels, its kernel
 * runs twice more, with 0 and with 1000 in their place. The pass is reported if the results differ. drydock's own
 * passes are not asked about textures of its own passes, because tests prove those. */
class DRYDOCK_API FUnwrittenWatch final : public IDispatchObserver
{
public:
	~FUnwrittenWatch() override;

	/** Called with a texture that a graph makes, before its first pass. True: nothing follows it, so that it has to be
	 * zeroed. */
	bool OnTextureMade(FRHITexture& Texture);
	/** Called after each pass: takes note of clears and copies. A texture that the pass writes by C++ counts as written
	 * as a whole. */
	void OnPassExecuted(const std::string& Pass, bool bForeign, const FPassCounters& Counters,
		const std::vector<FRDGTexture*>& WrittenTextures);

	bool AllowsReuse() const override { return true; }
	void BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;
	void AfterDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;

	/** Warnings (DD4006), in the order of the passes: each texture once for each reader. */
	const std::vector<FDiagnostic>& GetDiagnostics() const { return Diagnostics; }

private:
	struct FTexture
	{
		std::string Name;
		FRHITexture* Texture = nullptr;
		FKernelMip Mip = {};
		int32_t TexelBytes = 0;
		std::string Writer; // the pass that wrote last, and how
		bool bForeign = false;
		bool bWritten = false;       // something of it
		std::vector<bool> Unwritten; // by texel, once something is written
		uint64_t NumUnwritten = 0;   // the same
	};

	FTexture* Find(const FKernelTexture& Texture);
	void Begin(FTexture& Texture, bool bForeign, const std::string& Writer);
	void TakeRect(FTexture& Texture, const FIntRect& Rect);
	void FillUnwritten(const FTexture& Texture, uint8_t Byte) const;
	void TakeWhatIsLeft(FTexture& Texture, const FBoundShader& Shader, const FKernelArgs& Args,
		const FKernelTile& Whole, size_t Written);
	void AskReader(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole, size_t Slot);
	void ForgetWhole();

	std::map<const uint8_t*, FTexture> Textures; // those that are not written as a whole, by their first texel
	std::set<const uint8_t*> DrawnHere;          // textures of the pass that runs
	std::set<std::pair<std::string, std::string>> Reported;
	std::vector<FDiagnostic> Diagnostics;
};

} // namespace Drydock
