// The trace of a pixel through the passes of a run that somebody asked for, taken while the frame runs.
#pragma once

#include "DispatchObserver.h"
#include "Inspect/DispatchShaders.h"
#include "TraceRecorder.h"

#include <array>
#include <memory>
#include <optional>

namespace Drydock
{

struct FTraceRequest
{
	std::string Pass;            // pattern with * and ?, of a pass's name or its shader's
	std::array<int32_t, 3> At{}; // texel that the pass writes; z of a volume or an array
	bool bThread = false;        // At is the dispatch id of a compute thread
	double Bound = 1e-3;         // by which float and double part: of the larger, or of 1
	uint64_t MaxSteps = 1'000'000'000;
};

/** A place where the float trace and the one in double differ. */
struct FTraceDifference
{
	size_t Line = 0;  // index into the lines of the float trace
	size_t Event = 0; // of that line
	double Float = 0;
	double Double = 0;
	bool bOtherPath = false; // from there on they run other lines
};

/** One draw or dispatch that the thread is part of. */
struct FCapturedTrace
{
	std::string Pass;
	std::string Shader;
	std::string Entry;
	std::array<int32_t, 3> Thread{};
	std::string Stored; // compute: the texture whose texel the thread was asked by; empty: by its id
	std::shared_ptr<const FInspectedShader> Inspected; // names of types and lines of text
	FPixelTrace Float;
	FPixelTrace Double;
	std::optional<FTraceDifference> Difference;
	std::vector<std::array<double, 4>> Written; // by render target: the texel once the kernel has run
};

class DRYDOCK_API FTraceCapture final : public IDispatchObserver
{
public:
	explicit FTraceCapture(FTraceRequest InRequest);
	~FTraceCapture() override;

	void BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;
	void AfterDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override;

	/** In the order in which the passes ran. Throws FError (DD1020) when there is none: with the names that passes had,
	 * or the sizes of those that the pixel is outside of. */
	const std::vector<FCapturedTrace>& GetTraces() const;

private:
	const FTraceRequest Request;
	FDispatchShaders Shaders;
	std::vector<FCapturedTrace> Traces;
	std::vector<std::string> Passes;  // all that ran a shader
	std::vector<std::string> Outside; // "Tonemap (1920 x 1080)"
	bool bTracing = false;            // the dispatch that runs
};

/** The first value by which two traces differ more than by Bound of the larger, or of 1. */
DRYDOCK_API std::optional<FTraceDifference> FindDifference(
	const FPixelTrace& Float, const FPixelTrace& Double, double Bound);

/** Writes a trace for a person: lines of the source with what they did. */
DRYDOCK_API std::string MakeTraceText(const FCapturedTrace& Trace, const FTraceRequest& Request);
DRYDOCK_API std::string MakeTraceJson(const std::vector<FCapturedTrace>& Traces, const FTraceRequest& Request);

/** "(0.5, 0.25)", "{ Color: (1, 0, 0), Weight: 0.5 }" */
DRYDOCK_API std::string FormatTraceValue(const FSpirvModule& Module, const FTraceValue& Value);

} // namespace Drydock
