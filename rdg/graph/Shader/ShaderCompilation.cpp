// Asks the shader compiler for permutations: makes the request, declares their uniform buffers, keeps what comes back,
// warms many at once.
#include "ShaderCompilation.h"

#include "CodeScope.h"
#include "DiagnosticList.h"
#include "ShaderState.h"
#include "ShaderTier.h"
#include "UniformBufferStructs.h"

#include "HAL/IConsoleManager.h"

#include <algorithm>
#include <atomic>
#include <set>
#include <thread>

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarPrecision(TEXT("r.Drydock.Precision"), 0,
	TEXT("Arithmetic of shaders. 0: float; 1: double, of the float shader's parameters and literals."));

TAutoConsoleVariable<int32> CVarLaneWidth(TEXT("r.Drydock.LaneWidth"), 0,
	TEXT("Pixels per step of a shader. 0: the widest of this CPU; 4, 8, 16: that many floats (half as many doubles)."));

TAutoConsoleVariable<int32> CVarWaveSize(
	TEXT("r.Drydock.WaveSize"), 32, TEXT("Threads of a wave, as WaveGetLaneCount() gives it: 4, 8, 16, 32 or 64."));

TAutoConsoleVariable<int32> CVarForceDXC(TEXT("r.D3D.ForceDXC"), 1,
	TEXT("1: shaders have the rules of DXC and HLSL 2021. 0: those of FXC, which shader model 5 is compiled by: ?:, && "
		 "and "
		 "|| take vectors and evaluate all sides."));

/** Whose work compiling is, whoever asks for it. */
const FCodeOwner GCompiler{.Callback = "the shader compiler"};

/** `cbuffer View { float4 View_Member; ... };` and the buffer's resources as globals. */
FShaderUniformBuffer DescribeUniformBuffer(const FShaderParametersMetadata& Struct)
{
	FShaderUniformBuffer Buffer;
	Buffer.Name = Struct.GetShaderVariableName();
	const std::string& Name = Buffer.Name;
	std::string Constants;
	std::string Resources;
	for (const FHlslMember& Member : Struct.GetHlslMembers())
	{
		Buffer.Members.push_back(Member.Name);
		if (Member.IsConstant())
		{
			const std::string Elements = Member.NumElements ? "[" + std::to_string(Member.NumElements) + "]" : "";
			Constants += "\t" + Member.Type + " " + Name + "_" + Member.Name + Elements + ";\n";
		}
		else if (!Member.IsUniformBuffer() && !Member.Type.empty())
		{
			Resources += Member.Type + " " + Name + "_" + Member.Name + ";\n";
		}
	}
	Buffer.Declaration = (Constants.empty() ? "" : "cbuffer " + Name + "\n{\n" + Constants + "};\n") + Resources;
	return Buffer;
}

/** Adds those of the parameter struct, then all others that are registered: a shader may name them in functions that it
 * does not call. A read without a buffer is found when the shader is matched with its parameters. */
void AddUniformBuffers(const FShaderParametersMetadata* Metadata, FShaderCompileRequest& Request)
{
	const auto Add = [&Request](const FShaderParametersMetadata& Struct)
	{
		const std::string Name = Struct.GetShaderVariableName();
		const bool bKnown = std::ranges::any_of(
			Request.UniformBuffers, [&Name](const FShaderUniformBuffer& Buffer) { return Buffer.Name == Name; });
		if (!bKnown)
		{
			Request.UniformBuffers.push_back(DescribeUniformBuffer(Struct));
		}
	};
	if (Metadata)
	{
		for (const FHlslMember& Member : Metadata->GetHlslMembers())
		{
			if (Member.IsUniformBuffer())
			{
				Add(*Member.Struct);
			}
		}
	}
	for (const FShaderParametersMetadata* Struct : GetUniformBufferStructs())
	{
		Add(*Struct);
	}
}

void AddRules(FShaderCompileRequest& Request)
{
	Request.Lanes = GetShaderLaneConfig();
	if (CVarForceDXC.GetValueOnAnyThread() == 0)
	{
		Request.Defines.emplace_back(FxcRulesDefine, "1");
	}
}

} // namespace

FLaneConfig GetShaderLaneConfig()
{
	FLaneConfig Config;
	Config.bDouble = CVarPrecision.GetValueOnAnyThread() == 1;
	Config.WaveSize = CVarWaveSize.GetValueOnAnyThread();
	Config.Lanes = CVarLaneWidth.GetValueOnAnyThread() / (Config.bDouble ? 2 : 1);
	return Config;
}

FShaderCompileRequest MakeShaderCompileRequest(const FShaderRef& Shader, const FShaderParametersMetadata* Metadata)
{
	MapShippedShaders();
	const FShaderType& Type = *Shader.GetType();
	FShaderCompileRequest Request;
	Request.VirtualPath = Type.GetShaderFilename();
	Request.EntryPoint = Type.GetFunctionName();
	Request.Stage = Type.GetFrequency() == SF_Pixel    ? EShaderStage::Pixel
					: Type.GetFrequency() == SF_Vertex ? EShaderStage::Vertex
													   : EShaderStage::Compute;
	Request.Defines = Type.GetCompilationEnvironment(Shader->GetPermutationId()).GetDefines();
	AddRules(Request);
	AddUniformBuffers(Metadata, Request);
	return Request;
}

FShaderCompileRequest MakeShaderCompileRequest(
	const std::string& VirtualPath, const std::string& EntryPoint, EShaderStage Stage)
{
	MapShippedShaders();
	FShaderCompileRequest Request;
	Request.VirtualPath = VirtualPath;
	Request.EntryPoint = EntryPoint;
	Request.Stage = Stage;
	AddRules(Request);
	AddUniformBuffers(nullptr, Request);
	return Request;
}

namespace
{

std::mutex GListenerMutex;
std::function<void(const FShaderCompileRequest&)> GListener;

void TellListener(const FShaderCompileRequest& Request)
{
	const std::lock_guard Lock(GListenerMutex);
	if (GListener)
	{
		GListener(Request);
	}
}

} // namespace

FScopedCompileListener::FScopedCompileListener(std::function<void(const FShaderCompileRequest&)> Function)
{
	const std::lock_guard Lock(GListenerMutex);
	GListener = std::move(Function);
}

FScopedCompileListener::~FScopedCompileListener()
{
	const std::lock_guard Lock(GListenerMutex);
	GListener = nullptr;
}

namespace
{

/** Runs the compiler; its first message then says for which class and entry, which its file and line do not. */
template<typename TFunction>
auto CompileFor(const FShaderRef& Shader, TFunction Compile)
{
	const FCodeScope Scope(GCompiler);
	try
	{
		const FShaderCompileRequest Request = MakeShaderCompileRequest(Shader, Shader.GetRootParametersMetadata());
		TellListener(Request);
		return Compile(Request);
	}
	catch (const FError& Error)
	{
		std::vector<FDiagnostic> Diagnostics = Error.GetDiagnostics();
		const FShaderType& Type = *Shader.GetType();
		if (!Diagnostics.empty())
		{
			std::string& Message = Diagnostics.front().Message;
			Message.insert(std::min(Message.find('\n'), Message.size()), // lines of source may follow
				std::string(" (compiled for ") + Type.GetName() + ", entry " + Type.GetFunctionName() + ")");
		}
		throw FError(std::move(Diagnostics), Error.GetExitCode());
	}
}

} // namespace

std::shared_ptr<const FCompiledShader> GetCompiledShader(const FShaderRef& Shader, bool bQuads)
{
	const FLaneConfig Lanes = GetShaderLaneConfig();
	FShaderState& State = Shader->GetState();
	std::lock_guard Lock(State.Mutex);
	std::shared_ptr<const FCompiledShader>& Compiled =
		State.Compiled[{Lanes.bDouble, Lanes.Lanes, Lanes.WaveSize, bQuads}];
	if (!Compiled)
	{
		Compiled = CompileFor(Shader,
			[bQuads](FShaderCompileRequest Request)
			{
				Request.bQuads = bQuads;
				return GetShaderTier().Compile(Request);
			});
	}
	return Compiled;
}

std::shared_ptr<const FShaderReflection> GetShaderReflection(const FShaderRef& Shader)
{
	FShaderState& State = Shader->GetState();
	std::lock_guard Lock(State.Mutex);
	for (const auto& [Lanes, Compiled] : State.Compiled)
	{
		if (Compiled)
		{
			return std::shared_ptr<const FShaderReflection>(Compiled, &Compiled->Reflection);
		}
	}
	if (!State.Reflection)
	{
		State.Reflection = std::make_shared<FShaderReflection>(
			CompileFor(Shader, [](const FShaderCompileRequest& Request) { return GetShaderTier().Reflect(Request); }));
	}
	return State.Reflection;
}

std::string GetShaderFingerprint(const FShaderRef& Shader)
{
	return CompileFor(
		Shader, [](const FShaderCompileRequest& Request) { return GetShaderTier().Fingerprint(Request); });
}

void WarmShaders(const std::vector<FShaderRef>& Shaders, int32 NumThreads)
{
	if (Shaders.empty())
	{
		return;
	}
	static const size_t NumCores = std::max(1u, std::thread::hardware_concurrency()); // which reads a file
	const size_t NumWorkers = std::min(Shaders.size(), NumThreads > 0 ? static_cast<size_t>(NumThreads) : NumCores);
	std::atomic<size_t> Next = 0;
	std::vector<std::vector<FDiagnostic>> Failures(Shaders.size());
	std::vector<EExitCode> ExitCodes(Shaders.size());
	std::vector<std::exception_ptr> Faults(Shaders.size());
	const auto Work = [&]
	{
		for (size_t Index = Next++; Index < Shaders.size(); Index = Next++)
		{
			try
			{
				GetCompiledShader(Shaders[Index]);
			}
			catch (const FError& Error)
			{
				Failures[Index] = Error.GetDiagnostics();
				ExitCodes[Index] = Error.GetExitCode();
			}
			catch (...)
			{
				Faults[Index] = std::current_exception();
			}
		}
	};
	std::vector<std::thread> Workers;
	for (size_t Index = 0; Index < NumWorkers; ++Index)
	{
		Workers.emplace_back(Work);
	}
	for (std::thread& Worker : Workers)
	{
		Worker.join();
	}

	std::vector<FDiagnostic> All;
	std::set<EExitCode> Ends; // of those that failed
	for (size_t Index = 0; Index < Shaders.size(); ++Index)
	{
		if (Faults[Index])
		{
			std::rethrow_exception(Faults[Index]);
		}
		if (ExitCodes[Index] != ExitDone)
		{
			Ends.insert(ExitCodes[Index]);
		}
		AddNewDiagnostics(All, Failures[Index]); // permutations of one file fail alike
	}
	if (!All.empty())
	{
		throw FError(std::move(All), Ends.size() == 1 ? *Ends.begin() : ExitUsage);
	}
}

namespace
{

/** Calls Function with the state of every permutation so far. */
template<typename TFunction>
void ForEachState(TFunction Function)
{
	ForEachShaderType(
		[&](const FShaderType& Type)
		{
			Type.ForEachShader(
				[&](FShader& Shader)
				{
					FShaderState& State = Shader.GetState();
					const std::lock_guard Lock(State.Mutex);
					Function(State);
				});
		});
}

} // namespace

void ForgetShaders()
{
	GetShaderTier().Forget();
	ForEachState(
		[](FShaderState& State)
		{
			State.Compiled.clear();
			State.Reflection.reset();
			State.Plans.clear();
		});
}

void ForgetShadersOf(const std::vector<std::string>& Files)
{
	const FShaderFiles Edited(Files);
	GetShaderTier().Forget(Edited);
	ForEachState(
		[&Edited](FShaderState& State)
		{
			const bool bKept =
				!State.Compiled.empty() && std::ranges::none_of(State.Compiled, [&Edited](const auto& Entry)
											   { return !Entry.second || Edited.IsReadBy(Entry.second->Files); });
			if (!bKept)
			{
				State.Compiled.clear();
				State.Reflection.reset();
				State.Plans.clear();
			}
		});
}

} // namespace Drydock
