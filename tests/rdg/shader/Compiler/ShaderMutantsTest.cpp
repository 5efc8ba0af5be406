// Damaged shaders end in a picture or in a message, and so does a front end that crashes or hangs. Every mutant runs in
// a process of its own, so that one that takes its process with it is counted and named.
//
//   DRYDOCK_MUTANTS=1000 build/release/bin/test_rdg_Compiler --gtest_filter='ShaderMutants.*'
//
// takes that many instead of 60, and each that the front end accepts through the C++ compiler; its kernel fills a
// picture of 8 x 8. Without the variable the C++ text is the end of it, and the model runs a few threads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "BlankArguments.h"
#include "ContentHash.h"
#include "GlobalShader.h"
#include "ShaderCompilation.h"
#include "ShaderHarness.h"
#include "ShaderMutants.h"
#include "SpirvEmit.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;

constexpr int NumMutants = 60;
constexpr size_t NumProcesses = 2;
constexpr rlim_t CpuSecondsOfOne = 120; // of this process; the compilers have limits of their own
constexpr uint64_t StepsOfOne = 200'000;

enum class EOutcome : uint8_t
{
	Picture,
	Message,
	Endless, // compiles, and a loop of it does not end
	Fault,   // neither: an exception that is no message, or a message without number or text
	Crash,
	Count
};

struct FMutantResult
{
	EOutcome Outcome = EOutcome::Crash;
	std::string Text;
};

/** Every shader of the library: one permutation each, as passes ask for it. */
const std::vector<FShaderCompileRequest>& GetShippedShaders()
{
	static const std::vector<FShaderCompileRequest> Requests = []
	{
		std::vector<FShaderCompileRequest> Result;
		ForEachGlobalShader(
			[&Result](const FGlobalShaderType& Type)
			{
				const bool bDraws = Type.GetFrequency() == SF_Pixel || Type.GetFrequency() == SF_Compute;
				for (int32_t Id = 0; bDraws && Id < Type.GetPermutationCount(); ++Id)
				{
					if (Type.ShouldCompilePermutation(Id))
					{
						const FShaderRef Shader(Type.FindOrCreateShader(Id));
						Result.push_back(MakeShaderCompileRequest(Shader, Type.GetRootParametersMetadata()));
						break;
					}
				}
			});
		return Result;
	}();
	return Requests;
}

std::string ReadFile(const std::string& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

/** The request with its main file mutated. */
FShaderCompileRequest MakeMutant(uint32_t Seed, std::string& What)
{
	FShaderCompileRequest Request = GetShippedShaders()[Seed % GetShippedShaders().size()];
	const FShaderMutant Mutant = MutateShader(ReadFile(FindShaderFile(Request.VirtualPath)), Request.VirtualPath, Seed);
	Request.GeneratedFiles.emplace_back(Request.VirtualPath, Mutant.Text);
	What = Request.VirtualPath + ", " + Request.EntryPoint + ": " + Mutant.What;
	return Request;
}

/** All the way to C++ and through the model; with bCompile also through the compiler, unless the same C++ was
 * compiled before. Folder: remembers what was. */
EOutcome RunShader(const FShaderCompileRequest& Request, bool bCompile, const std::string& Folder)
{
	const FShaderSource Source = FlattenShader(Request);
	const std::vector<uint32_t> Words = CompileToSpirv(Source, Request);
	try
	{
		const FSpirvModule Module = ReadSpirv(Words);
		const FSpirvStructure Structure = BuildSpirvStructure(Module);
		const FSpirvReflection Reflection = ReflectSpirv(Module, Structure, Source.Text);
		const FSpirvUniformity Uniformity = AnalyzeUniformity(Module, Structure);
		const std::string Cpp = EmitKernel({Module, Structure, Uniformity, Reflection}, "mutant");
		const FBlankArguments Arguments(Reflection.Reflection, 1.0f);
		FSpirvInterpreter Interpreter(Module, Reflection);
		try
		{
			for (const int32_t X : {0, 5})
			{
				Interpreter.Run(Arguments.Get(), X, 3, 0, StepsOfOne);
			}
		}
		catch (const FSpirvError& Error)
		{
			if (std::string(Error.what()) == "the shader did not end")
			{
				return EOutcome::Endless;
			}
		}
		FContentHash Hash;
		Hash.Add(Cpp);
		const std::string Known = Folder + "/" + Hash.Finish();
		if (bCompile && !std::filesystem::exists(Known))
		{
			const std::shared_ptr<const FCompiledShader> Shader = CompileShader(Request);
			Shader->Run(Arguments.Get(), {0, 0, 0, FBlankArguments::Size, FBlankArguments::Size, 1});
			std::ofstream(Known) << "ran\n";
		}
	}
	catch (const FSpirvError& Error)
	{
		if (!*Error.what())
		{
			return EOutcome::Fault;
		}
		throw FError({ESeverity::Error, 6020, Error.what(), Error.File, Error.Line, 0, {}}, ExitUsage);
	}
	return EOutcome::Picture;
}

/** The same, as an outcome. */
FMutantResult Judge(const FShaderCompileRequest& Request, bool bCompile, const std::string& Folder)
{
	try
	{
		return {RunShader(Request, bCompile, Folder), ""};
	}
	catch (const FError& Error)
	{
		const std::vector<FDiagnostic>& Found = Error.GetDiagnostics();
		const bool bGood =
			!Found.empty() && Error.GetExitCode() == ExitUsage &&
			std::all_of(Found.begin(), Found.end(),
				[](const FDiagnostic& One) { return One.Code >= 6000 && One.Code < 7000 && !One.Message.empty(); });
		// 6030: the compiler refused our C++.
		return {bGood && Found[0].Code != 6030 ? EOutcome::Message : EOutcome::Fault, Error.what()};
	}
	catch (const std::exception& Error)
	{
		return {EOutcome::Fault, Error.what()};
	}
}

/** A process that judges one mutant. */
struct FJudge
{
	pid_t Child = 0;
	int Pipe = -1;
	std::string What;
};

FJudge StartJudge(uint32_t Seed, bool bCompile, const std::string& Folder)
{
	FJudge Judgement;
	const FShaderCompileRequest Request = MakeMutant(Seed, Judgement.What);
	int Ends[2];
	EXPECT_EQ(0, pipe(Ends));
	Judgement.Child = fork();
	if (Judgement.Child == 0)
	{
		const rlimit Limit{CpuSecondsOfOne, CpuSecondsOfOne};
		setrlimit(RLIMIT_CPU, &Limit);
		const FMutantResult Result = Judge(Request, bCompile, Folder);
		const std::string Text = Result.Text.substr(0, 4000); // fits a pipe that nobody reads yet
		const bool bWritten = write(Ends[1], Text.data(), Text.size()) == ssize_t(Text.size());
		_exit(bWritten ? int(Result.Outcome) : int(EOutcome::Fault));
	}
	close(Ends[1]);
	Judgement.Pipe = Ends[0];
	return Judgement;
}

FMutantResult FinishJudge(const FJudge& Judgement)
{
	FMutantResult Result;
	char Buffer[4096];
	for (ssize_t Count; (Count = read(Judgement.Pipe, Buffer, sizeof(Buffer))) > 0;)
	{
		Result.Text.append(Buffer, size_t(Count));
	}
	close(Judgement.Pipe);
	int Status = 0;
	while (waitpid(Judgement.Child, &Status, 0) < 0 && errno == EINTR)
	{
	}
	if (WIFEXITED(Status) && WEXITSTATUS(Status) < int(EOutcome::Count))
	{
		Result.Outcome = EOutcome(WEXITSTATUS(Status));
	}
	else
	{
		Result.Text = WIFSIGNALED(Status) ? "signal " + std::to_string(WTERMSIG(Status)) : "an exit by itself";
	}
	return Result;
}

/** A compiler of HLSL that is a shell script, for the scope. */
class FFakeFrontEnd
{
public:
	explicit FFakeFrontEnd(const std::string& Script)
	{
		const std::string Path = Folder.Reserve("dxc");
		std::ofstream(Path) << "#!/bin/sh\n" << Script << "\n";
		std::filesystem::permissions(Path, std::filesystem::perms::owner_all);
		setenv("DRYDOCK_HLSL_COMPILER", Path.c_str(), 1);
		setenv("DRYDOCK_HLSL_COMPILER_SECONDS", "1", 1);
	}
	~FFakeFrontEnd()
	{
		unsetenv("DRYDOCK_HLSL_COMPILER");
		unsetenv("DRYDOCK_HLSL_COMPILER_SECONDS");
	}

private:
	FTemporaryFolder Folder;
};

/** Messages of a shader that this front end gets. */
std::string ErrorsBy(const std::string& Script, int& ExitCode)
{
	const FFakeFrontEnd Fake(Script);
	FShaderHarness Harness("[numthreads(1, 1, 1)] void Main() {}\n", "Main", EShaderStage::Compute);
	try
	{
		CompileToSpirv(FlattenShader(Harness.Request), Harness.Request);
	}
	catch (const FError& Error)
	{
		ExitCode = Error.GetExitCode();
		return Error.what();
	}
	return {};
}

} // namespace

TEST(ShaderMutants, EndInAPictureOrAMessage)
{
	const char* const Wanted = std::getenv("DRYDOCK_MUTANTS");
	const int Number = Wanted ? std::max(1, std::atoi(Wanted)) : NumMutants;
	const FTemporaryFolder Temporary;
	const std::string Folder = Temporary.Reserve("judges");
	std::filesystem::create_directory(Folder);
	std::map<EOutcome, int> Outcomes;
	std::map<std::string, int> Codes;
	for (int First = 0; First < Number; First += int(NumProcesses))
	{
		std::vector<FJudge> Running;
		for (int Seed = First; Seed < std::min(Number, First + int(NumProcesses)); ++Seed)
		{
			Running.push_back(StartJudge(uint32_t(Seed), Wanted != nullptr, Folder));
		}
		for (size_t i = 0; i < Running.size(); ++i)
		{
			const FMutantResult Result = FinishJudge(Running[i]);
			++Outcomes[Result.Outcome];
			std::smatch Code;
			if (Result.Outcome == EOutcome::Message && std::regex_search(Result.Text, Code, std::regex("DD6\\d+")))
			{
				++Codes[Code.str()];
			}
			EXPECT_TRUE(Result.Outcome != EOutcome::Fault && Result.Outcome != EOutcome::Crash)
				<< "mutant " << First + int(i) << ", " << Running[i].What << ": " << Result.Text;
		}
	}
	std::printf("%d mutants: %d pictures, %d messages, %d without an end\n", Number, Outcomes[EOutcome::Picture],
		Outcomes[EOutcome::Message], Outcomes[EOutcome::Endless]);
	for (const auto& [Code, Count] : Codes)
	{
		std::printf("  %s: %d\n", Code.c_str(), Count);
	}
	// Mutations that nothing survives, or that nothing notices, would prove little.
	EXPECT_GT(Outcomes[EOutcome::Picture], Number / 10);
	EXPECT_GT(Outcomes[EOutcome::Message], Number / 10);
}

TEST(ShaderMutants, ComeFromEveryShippedFile)
{
	std::set<std::string> Mutated = {"PostProcessCombineLUTs.usf"}; // no pass has it: plugins include it
	for (const FShaderCompileRequest& Request : GetShippedShaders())
	{
		Mutated.insert(std::filesystem::path(Request.VirtualPath).filename().string());
	}
	for (const auto& Entry : std::filesystem::directory_iterator(DRYDOCK_TEST_SOURCE_DIR "/passes/Shaders"))
	{
		const std::string Name = Entry.path().filename().string();
		EXPECT_TRUE(Entry.path().extension() != ".usf" || Mutated.count(Name)) << Name;
	}
}

TEST(FrontEndFaults, CrashNamesTheSignal)
{
	int ExitCode = 0;
	EXPECT_THAT(ErrorsBy("kill -SEGV $$", ExitCode),
		testing::AllOf(HasSubstr("DD6012"), HasSubstr("dxc was ended by signal 11 on 'Main'")));
	EXPECT_EQ(ExitUsage, ExitCode);
}

TEST(FrontEndFaults, CrashAfterSomeOutputIsStillAMessage)
{
	int ExitCode = 0;
	EXPECT_THAT(ErrorsBy("echo /Test/Shader.usf; echo 'ERROR'; kill -ABRT $$", ExitCode), HasSubstr("signal 6"));
	EXPECT_EQ(ExitUsage, ExitCode);
}

TEST(FrontEndFaults, HangingIsEndedAndSaidToBe)
{
	int ExitCode = 0;
	EXPECT_THAT(ErrorsBy("trap '' TERM; sleep 100", ExitCode),
		testing::AllOf(HasSubstr("DD6012"), HasSubstr("dxc took longer than 1 s on 'Main'")));
	EXPECT_EQ(ExitUsage, ExitCode);
}

TEST(FrontEndFaults, EndlessOutputIsEnded)
{
	int ExitCode = 0;
	EXPECT_THAT(ErrorsBy("yes ERROR", ExitCode), HasSubstr("took longer than 1 s"));
	EXPECT_EQ(ExitUsage, ExitCode);
}

TEST(FrontEndFaults, SuccessWithoutAModuleIsAMessage)
{
	for (const auto& [Script, Message] :
		{std::pair("exit 0", "DD6012: dxc has written nothing that can be read for 'Main': No such file"),
			std::pair("while [ \"$1\" != -Fo ]; do shift; done; echo 'twenty bytes and no module' >\"$2\"",
				"SPIR-V: not a module")})
	{
		const FFakeFrontEnd Fake(Script);
		FShaderHarness Harness("// no module\n[numthreads(1, 1, 1)] void Main() {}\n", "Main", EShaderStage::Compute);
		EXPECT_THAT(ErrorOf([&Harness] { ReflectShader(Harness.Request); }), HasSubstr(Message));
	}
}
