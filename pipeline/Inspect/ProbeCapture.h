// Follows a pixel through all passes of a run: the values that each pass read for it and wrote.
#pragma once

#include "DispatchObserver.h"
#include "Footprint.h"
#include "Inspect/DispatchShaders.h"
#include "TexelWriter.h"

#include <array>
#include <optional>

namespace Drydock
{

struct FProbeRequest
{
	int32_t X = 0; // of a picture as large as Frame
	int32_t Y = 0;
	int32_t Width = 1; // region, from X and Y
	int32_t Height = 1;
	std::string Passes = "*";          // pattern, of a pass's name or its shader's
	std::array<int32_t, 2> Frame = {}; // size of what X and Y count in; 0: each pass's own
};

struct FProbeTexel
{
	std::string Format; // of its storage, "RGBA16_FLOAT"
	int32_t X = 0;
	int32_t Y = 0;
	int NumChannels = 4;
	std::array<double, 4> Value{}; // exactly as stored
};

/** One texture that a pass read for the pixel, and what it read. */
struct FProbeRead
{
	std::string Texture;                 // as the shader calls it
	std::array<int32_t, 2> Size = {};    // of its largest mip
	std::optional<FProbeTexel> AtPixel;  // that covers the pixel's centre, before the pass; none of a volume
	uint64_t NumReads = 0;               // samples and loads
	std::vector<FFootprintTexel> Texels; // with the weights of all samples together, of loads 1 each
};

/** A number or vector that the pass's thread read of groupshared memory. */
struct FProbeShared
{
	std::string Name; // "Tile[3]"
	std::vector<double> Value;
	std::array<int32_t, 3> Writer = {}; // the thread that had put it there
	int WriterLine = 0;                 // and its line; 0: nothing wrote it
};

/** A texel after the pass. */
struct FProbeWrite : FProbeTexel
{
	std::string Target; // "SV_Target0", or as the shader calls it
};

struct FProbePass
{
	std::string Pass;
	std::string Shader;
	bool bDrawn = true;                // false: the pass draws or dispatches elsewhere; its texel is what was there
	std::vector<FTexelWriter> Threads; // compute: by texture, the thread that stored to the texel
	std::vector<FProbeRead> Reads;     // of these threads, or of the pixel
	std::vector<FProbeShared> Shared;
	std::vector<FProbeWrite> Writes; // rows of the region, target by target
};

class DRYDOCK_API FProbeCapture final : public IDispatchObserver
{
public:
	explicit FProbeCapture(FProbeRequest InRequest);
	~FProbeCapture() override;

	void BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;
	void AfterDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;

	const std::vector<FProbePass>& GetPasses() const { return Passes; }

private:
	/** Maps the request's pixel to a picture of another size: to the texel that covers its centre. */
	std::array<int32_t, 2> Map(int32_t X, int32_t Y, int32_t SizeX, int32_t SizeY) const;
	void AddReads(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole, FProbePass& Pass);
	void AddTexel(const FBoundShader& Shader, FProbeRead& Read) const;
	void AddWrites(const std::string& Name, const FKernelTexture& Texture, FProbePass& Pass) const;

	const FProbeRequest Request;
	FDispatchShaders Shaders;
	std::vector<FProbePass> Passes;
	bool bProbing = false; // the dispatch that runs
};

/** The place where two probes part: the first pass whose texels differ. */
struct FProbeDifference
{
	size_t Pass = 0;
	size_t Write = 0;
	bool bOtherPasses = false; // another pass runs there
};
DRYDOCK_API std::optional<FProbeDifference> FindDifference(
	const std::vector<FProbePass>& A, const std::vector<FProbePass>& B);

/** Against: empty where nothing is compared. */
DRYDOCK_API std::string MakeProbeText(
	const std::vector<FProbePass>& Passes, const std::vector<FProbePass>& Against, const FProbeRequest& Request);
DRYDOCK_API std::string MakeProbeJson(
	const std::vector<FProbePass>& Passes, const std::vector<FProbePass>& Against, const FProbeRequest& Request);

} // namespace Drydock
