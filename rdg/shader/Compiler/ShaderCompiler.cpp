// Runs the stages in a row, and looks before them into memory and onto the disk.
#include "ShaderCompiler.h"

#include "ContentHash.h"
#include "Diagnostics.h"
#include "HlslCompiler.h"
#include "KernelCompiler.h"
#include "LanesDispatch.h"
#include "ShaderCache.h"
#include "ShaderFrontEnd.h"
#include "ShaderMessages.h"
#include "ShaderSource.h"
#include "SpirvBarriers.h"
#include "SpirvEmit.h"
#include "SpirvInterpreter.h"
#include "SpirvQuads.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <map>
#include <mutex>
#include <set>
#include <utility>

namespace Drydock
{

namespace
{

/** The hash of the tier's own text, which the build writes (CMakeLists.txt). */
constexpr const char* ShaderTierHash =
#include <ShaderTierHash.inl>
	;

/** One request in memory. Requests for the same shader wait for the first. */
template<typename T>
struct TSlot
{
	std::mutex Mutex;
	std::shared_ptr<const T> Value;
};

template<typename T>
class TMemory
{
public:
	template<typename FMake>
	std::shared_ptr<const T> Find(const std::string& Key, FMake Make)
	{
		std::shared_ptr<TSlot<T>> Slot;
		{
			const std::lock_guard Lock(Mutex);
			std::shared_ptr<TSlot<T>>& Known = Slots[Key];
			Known = Known ? Known : std::make_shared<TSlot<T>>();
			Slot = Known;
		}
		const std::lock_guard Lock(Slot->Mutex);
		if (!Slot->Value)
		{
			Slot->Value = Make();
		}
		return Slot->Value;
	}

	/** Forgets the values for which Is is true. */
	template<typename FIs>
	void Remove(FIs Is)
	{
		const std::lock_guard Lock(Mutex);
		std::erase_if(Slots,
			[&Is](const auto& Entry)
			{
				const std::lock_guard SlotLock(Entry.second->Mutex);
				return !Entry.second->Value || Is(*Entry.second->Value);
			});
	}

	void Clear()
	{
		const std::lock_guard Lock(Mutex);
		Slots.clear();
	}

private:
	std::mutex Mutex;
	std::map<std::string, std::shared_ptr<TSlot<T>>> Slots;
};

TMemory<FCompiledShader>& GetKernels()
{
	static TMemory<FCompiledShader> Memory;
	return Memory;
}

/** A reflection, and the files on disk behind it. */
struct FReflectedShader
{
	FShaderReflection Reflection;
	std::vector<std::string> Files;
};

TMemory<FReflectedShader>& GetReflections()
{
	static TMemory<FReflectedShader> Memory;
	return Memory;
}

/** Flattened text by what was asked: reflection and kernel share it. */
TMemory<FShaderSource>& GetSources()
{
	static TMemory<FShaderSource> Memory;
	return Memory;
}

/** SPIR-V by the source it was made of: reflection and kernel, in every arithmetic, come from one front-end run. */
TMemory<std::vector<uint32_t>>& GetWords()
{
	static TMemory<std::vector<uint32_t>> Memory;
	return Memory;
}

/** Hash of what was asked, not of the files behind it. */
std::string HashRequest(const FShaderCompileRequest& Request)
{
	FContentHash Hash;
	const auto AddPairs = [&Hash](const std::vector<std::pair<std::string, std::string>>& Pairs)
	{
		Hash.Add(std::to_string(Pairs.size()));
		for (const auto& [First, Second] : Pairs)
		{
			Hash.Add(First);
			Hash.Add(Second);
		}
	};
	Hash.Add(Request.VirtualPath);
	Hash.Add(Request.EntryPoint);
	Hash.Add(std::to_string(int(Request.Stage)));
	AddPairs(Request.Defines);
	AddPairs(Request.GeneratedFiles);
	for (const FShaderUniformBuffer& Buffer : Request.UniformBuffers)
	{
		Hash.Add(Buffer.Name);
		Hash.Add(Buffer.Declaration);
		Hash.Add(std::to_string(Buffer.Members.size()));
		for (const std::string& Member : Buffer.Members)
		{
			Hash.Add(Member);
		}
	}
	Hash.Add(GetHlslCompilerId(Request));
	return Hash.Finish();
}

std::string HashSource(const FShaderSource& Source, const FShaderCompileRequest& Request, const std::string& Build)
{
	FContentHash Hash;
	Hash.Add(ShaderTierHash);
	Hash.Add(Source.Text);
	Hash.Add(Request.EntryPoint);
	Hash.Add(std::to_string(int(Request.Stage)));
	Hash.Add(Build);
	Hash.Add(GetHlslCompilerId(Request));
	return Hash.Finish();
}

std::shared_ptr<const FShaderSource> FlattenOnce(const FShaderCompileRequest& Request)
{
	return GetSources().Find(HashRequest(Request) + (Request.bKeepFunctions ? "k" : ""),
		[&] { return std::make_shared<FShaderSource>(FlattenShader(Request)); });
}

std::vector<uint32_t> CompileOnce(const FShaderSource& Source, const FShaderCompileRequest& Request)
{
	return *GetWords().Find(HashSource(Source, Request, {}),
		[&] { return std::make_shared<std::vector<uint32_t>>(CompileToSpirv(Source, Request)); });
}

struct FAnalysedShader
{
	FSpirvModule Module;
	FSpirvStructure Structure;
	FSpirvReflection Reflection;
};

/** Runs Work; what it finds wrong with the SPIR-V becomes a message about the shader. */
template<typename FWork>
auto ExplainSpirvErrors(const FShaderCompileRequest& Request, FWork Work)
{
	try
	{
		return Work();
	}
	catch (const FSpirvError& Error)
	{
		const bool bKnown = !Error.File.empty();
		const bool bLimit = dynamic_cast<const FSpirvLimitError*>(&Error) != nullptr;
		const std::string Entry = "entry point " + Request.EntryPoint;
		const std::string Message = Error.what() + (bKnown && bLimit ? " (" + Entry + ")" : std::string());
		const std::string File = bKnown ? Error.File : Request.VirtualPath;
		const std::string Where = bKnown ? std::string() : Entry;
		throw FError(bLimit ? FDiagnostic{ESeverity::Error, 6021, Message, File, Error.Line, 0, Where}
							: FDiagnostic{ESeverity::Error, 6020, Message, File, Error.Line, 0, Where},
			ExitUsage);
	}
}

/** For FShaderReflection::PartedBarrier. */
std::string FindPartedBarrier(const FSpirvModule& Module, const FSpirvStructure& Structure)
{
	const std::vector<FDivergentBarrier> Found =
		FindDivergentBarriers(Module, Structure, AnalyzeUniformity(Module, Structure));
	return Found.empty() ? std::string()
						 : Module.Files[Found[0].Barrier->File] + ":" + std::to_string(Found[0].Barrier->Line);
}

FAnalysedShader Analyse(
	const std::vector<uint32_t>& Words, const FShaderSource& Source, const FShaderCompileRequest& Request)
{
	return ExplainSpirvErrors(Request,
		[&]
		{
			FAnalysedShader Result;
			Result.Module = ReadSpirv(Words);
			if (Request.bQuads)
			{
				RunByQuads(Result.Module);
			}
			Result.Structure = BuildSpirvStructure(Result.Module);
			Result.Reflection = ReflectSpirv(Result.Module, Result.Structure, Source.Text);
			if (Result.Reflection.Reflection.bGroups)
			{
				Result.Reflection.Reflection.PartedBarrier = FindPartedBarrier(Result.Module, Result.Structure);
			}
			return Result;
		});
}

/** The lane headers in the cache, as one compiler takes them. */
struct FPrecompiledHeaders
{
	FPrecompiledHeaders(const FShaderCache& InCache, const std::string& CompilerId, const FLaneConfig& InLanes)
		: Cache(InCache)
		, Lanes(InLanes)
		, Name("headers/" + GetKernelBuildIdentity(InLanes) + "." + CompilerId + ".gch")
		, File(InCache.OpenPrecompiled(Name))
	{
	}

	/** Once in a process at most, whatever comes of it. */
	void MakeMissing() const
	{
		static std::mutex Mutex;
		static std::set<std::string> Made;
		if (File || !Cache.TakesPrecompiled())
		{
			return;
		}
		{
			const std::lock_guard Lock(Mutex);
			if (!Made.insert(Name).second)
			{
				return;
			}
		}
		if (const std::string Bytes = PrecompileKernelHeaders(Lanes); !Bytes.empty())
		{
			Cache.StorePrecompiled(Name, Bytes);
		}
	}

	const FShaderCache& Cache;
	const FLaneConfig Lanes;
	const std::string Name;
	const FFileDescriptor File; // none where they are not there yet
};

/** From source to a loaded kernel, past every cache. */
void Build(const FShaderSource& Source, const FShaderCompileRequest& Request, const FShaderCache& Cache,
	const std::string& CompilerId, FCompiledShader& Result)
{
	const FAnalysedShader Shader = Analyse(CompileOnce(Source, Request), Source, Request);
	const std::string Cpp = ExplainSpirvErrors(Request,
		[&]
		{
			const FSpirvUniformity Uniformity = AnalyzeUniformity(Shader.Module, Shader.Structure);
			return EmitKernel(
				{Shader.Module, Shader.Structure, Uniformity, Shader.Reflection, uint32_t(Result.Lanes.WaveSize)},
				Request.VirtualPath + ", entry " + Request.EntryPoint);
		});
	Result.Reflection = Shader.Reflection.Reflection;
	const FTemporaryFolder Folder;
	const FPrecompiledHeaders Headers(Cache, CompilerId, Result.Lanes);
	const std::string SharedObject = CompileKernel(Cpp, Folder, Result.Lanes, Request, Headers.File);
	Headers.MakeMissing(); // after a kernel that compiles: a fault of the compiler is reported for the shader
	if (!Request.bQuads)   // that of the shader as it is
	{
		Cache.StoreReflection(HashSource(Source, Request, {}), Result.Reflection);
	}
	const std::string Stored = Cache.StoreKernel(Result.Key, CompilerId, Result.Reflection, SharedObject);
	std::string Fault;
	for (const std::string& Place : {Stored, SharedObject}) // code may run in one folder and not in the other
	{
		Result.Run = Result.Run || Place.empty() ? Result.Run : LoadKernel(Place, Result.Lanes, Fault);
	}
	if (!Result.Run)
	{
		throw FError(
			{ESeverity::Error, 6034, "the kernel compiled for '" + Request.EntryPoint + "' cannot be loaded: " + Fault,
				Request.VirtualPath, 0, 0, {}},
			ExitFiles);
	}
}

bool LoadFromCache(const FShaderCache& Cache, const std::string& CompilerId, FCompiledShader& Result)
{
	const std::optional<FCachedShader> Found = Cache.FindKernel(Result.Key, CompilerId);
	if (!Found)
	{
		return false;
	}
	std::string Ignored;
	Result.Run = LoadKernel(Found->SharedObject, Result.Lanes, Ignored);
	Result.Reflection = Found->Reflection;
	Result.bFromCache = Result.Run != nullptr;
	return Result.bFromCache;
}

/** The words of a vertex shader's SPIR-V: from the cache, or from the front end and then there. An entry is the hash of
 * the words, and the words. */
std::vector<uint32_t> FindVertexWords(
	const FShaderSource& Source, const FShaderCompileRequest& Request, const std::string& Key)
{
	const FShaderCache Cache = FShaderCache::Open();
	const std::string Name = Key.substr(0, 2) + "/" + Key + ".vertex.spv";
	const size_t HashSize = HashBytes({}).size();
	const std::string Entry = Cache.ReadText(Name).value_or("");
	if (Entry.size() > HashSize && HashBytes(Entry.substr(HashSize)) == Entry.substr(0, HashSize))
	{
		std::vector<uint32_t> Words((Entry.size() - HashSize) / sizeof(uint32_t));
		std::memcpy(Words.data(), Entry.data() + HashSize, Words.size() * sizeof(uint32_t));
		return Words;
	}
	const std::vector<uint32_t> Words = CompileToSpirv(Source, Request);
	const std::string Bytes(reinterpret_cast<const char*>(Words.data()), Words.size() * sizeof(uint32_t));
	Cache.StoreText(Name, HashBytes(Bytes) + Bytes);
	return Words;
}

/** Vertex shaders are interpreted: there is no kernel to compile. */
std::shared_ptr<const FCompiledShader> MakeVertexShader(const FShaderCompileRequest& Request)
{
	const auto Result = std::make_shared<FCompiledShader>();
	const std::shared_ptr<const FShaderSource> Flattened = FlattenOnce(Request);
	const FShaderSource& Source = *Flattened;
	Result->Files = Source.Files;
	Result->Fingerprint = Source.Fingerprint;
	Result->Key = HashSource(Source, Request, {});
	FAnalysedShader Shader = Analyse(FindVertexWords(Source, Request, Result->Key), Source, Request);
	Result->Reflection = Shader.Reflection.Reflection;
	Result->Vertex = MakeVertexProgram(std::move(Shader.Module), std::move(Shader.Reflection));
	return Result;
}

std::shared_ptr<const FCompiledShader> MakeShader(const FShaderCompileRequest& Request, const FLaneConfig& Lanes)
{
	if (Request.Stage == EShaderStage::Vertex)
	{
		return MakeVertexShader(Request);
	}
	const auto Start = std::chrono::steady_clock::now();
	const auto Result = std::make_shared<FCompiledShader>();
	const std::shared_ptr<const FShaderSource> Flattened = FlattenOnce(Request);
	const FShaderSource& Source = *Flattened;
	const FShaderCache Cache = FShaderCache::Open();
	const std::string CompilerId = GetCompilerId(FindKernelCompiler());
	Result->Lanes = Lanes;
	Result->Files = Source.Files;
	Result->Fingerprint = Source.Fingerprint;
	const bool bUsualWaves = Lanes.WaveSize == FLaneConfig().WaveSize;
	Result->Key = HashSource(Source, Request,
		GetKernelBuildIdentity(Lanes) + (bUsualWaves ? std::string() : " waves of " + std::to_string(Lanes.WaveSize)) +
			(Request.bQuads ? " quads" : ""));
	if (!LoadFromCache(Cache, CompilerId, *Result))
	{
		Cache.WithLock(Result->Key,
			[&]
			{
				if (!LoadFromCache(Cache, CompilerId, *Result)) // another process may have been faster
				{
					Build(Source, Request, Cache, CompilerId, *Result);
				}
			});
	}
	Result->CompileMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Start).count();
	return Result;
}

/** Runs Work; errors of it show the lines that they are about. */
template<typename FWork>
auto WithLines(const FShaderCompileRequest& Request, FWork Work)
{
	try
	{
		return Work();
	}
	catch (const FError& Error)
	{
		throw ExplainShaderErrors(Error, Request);
	}
}

} // namespace

std::shared_ptr<const FCompiledShader> CompileShader(const FShaderCompileRequest& Request)
{
	const FLaneConfig Lanes = ResolveLanes(Request.Lanes);
	const std::string Key = HashRequest(Request) + (Lanes.bDouble ? "d" : "f") + std::to_string(Lanes.Lanes) + "w" +
							std::to_string(Lanes.WaveSize) + (Request.bQuads ? "q" : "");
	return WithLines(Request, [&] { return GetKernels().Find(Key, [&] { return MakeShader(Request, Lanes); }); });
}

FShaderReflection ReflectShader(const FShaderCompileRequest& Request)
{
	const auto Make = [&]() -> std::shared_ptr<const FReflectedShader>
	{
		const std::shared_ptr<const FShaderSource> Flattened = FlattenOnce(Request);
		const FShaderSource& Source = *Flattened;
		const FShaderCache Cache = FShaderCache::Open();
		const std::string Key = HashSource(Source, Request, {});
		std::optional<FShaderReflection> Reflection = Cache.FindReflection(Key);
		if (!Reflection)
		{
			Reflection = Analyse(CompileOnce(Source, Request), Source, Request).Reflection.Reflection;
			Cache.StoreReflection(Key, *Reflection);
		}
		return std::make_shared<FReflectedShader>(FReflectedShader{std::move(*Reflection), Source.Files});
	};
	return WithLines(Request, [&] { return GetReflections().Find(HashRequest(Request), Make)->Reflection; });
}

std::string FingerprintShader(const FShaderCompileRequest& Request)
{
	return FlattenOnce(Request)->Fingerprint;
}

void ForgetCompiledShaders()
{
	GetKernels().Clear();
	GetReflections().Clear();
	GetSources().Clear();
	GetWords().Clear();
}

void ForgetCompiledShaders(const FShaderFiles& Files)
{
	const auto Read = [&Files](const auto& Made)
	{
		return Files.IsReadBy(Made.Files);
	};
	GetKernels().Remove(Read);
	GetReflections().Remove(Read);
	GetSources().Remove(Read);
	GetWords().Clear();
}

namespace
{

class FShaderTier : public IShaderTier
{
public:
	FShaderTier() { RegisterShaderTier(*this); }

	std::shared_ptr<const FCompiledShader> Compile(const FShaderCompileRequest& Request) override
	{
		return CompileShader(Request);
	}
	FShaderReflection Reflect(const FShaderCompileRequest& Request) override { return ReflectShader(Request); }
	std::string Fingerprint(const FShaderCompileRequest& Request) override { return FingerprintShader(Request); }
	void Forget() override { ForgetCompiledShaders(); }
	void Forget(const FShaderFiles& Files) override { ForgetCompiledShaders(Files); }
};

FShaderTier GShaderTier;

} // namespace

} // namespace Drydock
