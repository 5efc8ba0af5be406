// A debugger's stop in the shaders of a run: beside each pass its shader runs once more for one pixel, in a form whose
// lines and variables gdb knows.
#pragma once

#include "DebuggedShader.h"
#include "Diagnostics.h"
#include "DispatchObserver.h"

#include <map>
#include <memory>

namespace Drydock
{

struct FDebugRequest
{
	/** A pixel of a picture as large as Frame: in a smaller one, the texel that covers its centre. With bThread: the
	 * dispatch id of compute shaders, which alone run then. */
	std::array<int32_t, 3> At{};
	bool bThread = false;
	std::string Passes = "*";            // pattern, of a pass's name or its shader's
	std::array<int32_t, 2> Frame = {};   // 0: each pass's own size
	uint64_t MaxSteps = 100'000'000'000; // of one thread
};

/** One thread that ran. */
struct FDebuggedPass
{
	std::string Pass;
	std::string Shader;
	std::array<int32_t, 3> At{};
	FDebuggedThread Thread;
};

class DRYDOCK_API FDebugCapture final : public IDispatchObserver
{
public:
	explicit FDebugCapture(FDebugRequest InRequest);
	~FDebugCapture() override;

	void BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;

	/** In the order in which they ran. */
	const std::vector<FDebuggedPass>& GetPasses() const { return Passes; }
	/** A warning DD6060 for each shader that no debugger can be given, and where there is no debugger. Throws FError
	 * (DD1020) when no pass fits the pattern or has the pixel, with the names that there are. */
	std::vector<FDiagnostic> GetDiagnostics() const;

private:
	std::optional<std::array<int32_t, 3>> FindThread(
		const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) const;
	const FDebuggedShader* FindShader(const FBoundShader& Shader, const std::string& Pass);

	const FDebugRequest Request;
	/** Shaders by permutation, and whether they run by quads. Null: the shader cannot be debugged. */
	std::map<std::pair<FShader*, bool>, std::unique_ptr<FDebuggedShader>> Shaders;
	std::vector<FDebuggedPass> Passes;
	std::vector<FDiagnostic> Problems;
	std::vector<std::string> Others; // passes that do not fit, or do not have the pixel
};

/** Makes the request from "X,Y" or "X,Y,Z" on the command line. Frame: size of the resulting frame. Throws FError
 * (DD1020). */
DRYDOCK_API FDebugRequest MakeDebugRequest(
	const std::string& Pixel, const std::string& Passes, const std::array<int32_t, 2>& Frame);

} // namespace Drydock
