// One test in the format of LLVM's offload test suite: HLSL, a pipeline in YAML with buffers and what they shall hold,
// and run lines that tell how the HLSL is compiled.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Drydock::Conformance
{

/** Why a test cannot be read here: a part of the format that this reader does not have. */
class FNotRead : public std::runtime_error
{
public:
	using std::runtime_error::runtime_error;
};

enum class EFormat : uint8_t
{
	Hex8,
	Hex16,
	Hex32,
	Hex64,
	UInt16,
	UInt32,
	UInt64,
	Int16,
	Int32,
	Int64,
	Float16,
	Float32,
	Float64,
	Bool
};

uint32_t GetSize(EFormat Format);

struct FBuffer
{
	std::string Name;
	EFormat Format = EFormat::Hex32;
	uint32_t Channels = 1;
	uint32_t Stride = 0;                       // bytes of a struct; 0: Channels values
	std::vector<std::vector<uint8_t>> Members; // bytes; several: an array of resources
	std::array<int32_t, 3> Size = {0, 0, 0};   // texels of a texture: width, height, depth
	int32_t MipLevels = 1;

	uint32_t GetElementSize() const { return Stride ? Stride : GetSize(Format) * Channels; }
};

struct FSampler
{
	std::string Name;
	bool bLinear = true;
	std::string Address = "Clamp";
};

struct FResource
{
	std::string Name; // of its buffer or sampler
	std::string Kind; // "RWStructuredBuffer", "Sampler", ...
	int32_t Register = -1;
	int32_t Space = 0;
	int32_t Binding = -1; // Vulkan's
	int32_t Set = 0;

	/** 't', 'u', 'b' or 's', as in register(u0). */
	char GetRegisterClass() const;
};

enum class ERule : uint8_t
{
	BufferExact,
	BufferFloatULP,
	BufferFloatEpsilon
};

struct FResult
{
	std::string Name;
	ERule Rule = ERule::BufferExact;
	std::string Actual;
	std::string Expected;
	bool bDenormalMayBeZero = true; // DenormMode: Any
	uint32_t Ulps = 0;
	double Epsilon = 0;
	double ZeroTolerance = 0;
	bool bFirstOnly = false; // what stands behind the expected values is not told
};

/** A call of the compiler. */
struct FShaderSourceText
{
	std::string Text; // on the lines on which it stands in the test's file
	std::vector<std::pair<std::string, std::string>> Defines;
	bool bRowMajor = false; // -Zpr
};

struct FPipeline
{
	std::string Entry;
	std::vector<FBuffer> Buffers;
	std::vector<FSampler> Samplers;
	std::vector<FResource> Resources;
	std::vector<FResult> Results;
	std::array<int32_t, 3> GroupCount = {1, 1, 1};
	std::vector<uint8_t> PushConstants;
	std::map<std::string, std::string> Specialized; // values of constants, by their [[vk::constant_id]]

	FBuffer* FindBuffer(const std::string& Name);
	const FBuffer* FindBuffer(const std::string& Name) const;
	const FSampler* FindSampler(const std::string& Name) const;
	bool HasCounters() const;
};

/** Behind the name of a buffer: its hidden counter, one uint32 for each member, where a resource has HasCounter. */
constexpr const char* CounterSuffix = "@count";

/** A shader and the pipeline that runs it. A test can have several. */
struct FRun
{
	FShaderSourceText Shader;
	FPipeline Pipeline;
};

struct FTest
{
	std::vector<FRun> Runs;
	int32_t WaveSize = 0; // that the test asks for; 0: any
};

/** Reads the file at Path. Throws FNotRead. */
FTest ReadTest(const std::string& Path);

/** Reads a pipeline. Throws FNotRead. */
FPipeline ReadPipeline(const std::string& Yaml);

/** Adds results of a pipeline whose expected values stand only in the lines for LLVM's FileCheck ("Name: Out",
 * "Counter: 4", "Counters: [ 1, 2 ]", "Data: [ 0x3 ]"). Throws FNotRead. */
void AddChecks(const std::vector<std::string>& Lines, FPipeline& Pipeline);

} // namespace Drydock::Conformance
