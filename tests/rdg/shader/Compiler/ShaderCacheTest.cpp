// The cache on disk gives hits without a compiler, and survives damage and other processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderHarness.h"

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
namespace fs = std::filesystem;
using testing::HasSubstr;

/** A cache of its own for one test. */
class FShaderCacheTest : public testing::Test
{
protected:
	void SetUp() override
	{
		std::string Pattern = (fs::temp_directory_path() / "drydock-cache-test-XXXXXX").string();
		ASSERT_TRUE(mkdtemp(Pattern.data()));
		Folder = Pattern;
		const char* Old = std::getenv("DRYDOCK_CACHE_DIR");
		OldFolder = Old ? Old : "";
		setenv("DRYDOCK_CACHE_DIR", Folder.c_str(), 1);
		ForgetCompiledShaders();
	}
	void TearDown() override
	{
		OldFolder.empty() ? unsetenv("DRYDOCK_CACHE_DIR") : setenv("DRYDOCK_CACHE_DIR", OldFolder.c_str(), 1);
		ForgetCompiledShaders();
		std::error_code Error;
		fs::remove_all(Folder, Error);
	}

	/** A shader that writes Value. */
	static FShaderHarness MakeShader(const std::string& Value = "3")
	{
		FShaderHarness Harness("RWStructuredBuffer<float> Out;\n[numthreads(8, 1, 1)] void Main(uint3 Id : "
							   "SV_DispatchThreadID) { Out[Id.x] = " +
								   Value + "; }\n",
			"Main", EShaderStage::Compute);
		Harness.Buffers["Out"].assign(4, 0);
		return Harness;
	}
	static float RunShader(FShaderHarness& Harness, bool* bFromCache = nullptr)
	{
		const std::shared_ptr<const FCompiledShader> Shader = Harness.Run(4, 4, 1);
		if (bFromCache)
		{
			*bFromCache = Shader->bFromCache;
		}
		return Harness.BufferFloat("Out", 2);
	}
	std::vector<fs::path> FilesWith(const std::string& Extension) const
	{
		std::vector<fs::path> Result;
		for (const fs::directory_entry& Entry : fs::recursive_directory_iterator(Folder))
		{
			if (Entry.path().extension() == Extension)
			{
				Result.push_back(Entry.path());
			}
		}
		return Result;
	}

	std::string Folder;
	std::string OldFolder;
};

/** Nothing to compile with, in this scope. */
class FNoCompilers
{
public:
	FNoCompilers()
		: Path(std::getenv("PATH"))
	{
		setenv("DRYDOCK_CXX", "/nonexistent", 1);
		setenv("PATH", "/nonexistent", 1);
	}
	~FNoCompilers()
	{
		unsetenv("DRYDOCK_CXX");
		setenv("PATH", Path.c_str(), 1);
	}

private:
	std::string Path;
};

} // namespace

TEST_F(FShaderCacheTest, SecondRequestNeedsNoCompiler)
{
	FShaderHarness Harness = MakeShader();
	RunShader(Harness);
	ForgetCompiledShaders();
	const FNoCompilers None;
	FShaderHarness Again = MakeShader();
	bool bFromCache = false;
	EXPECT_EQ(3.0f, RunShader(Again, &bFromCache));
	EXPECT_TRUE(bFromCache);
}

TEST_F(FShaderCacheTest, ReflectionNeedsNoCompilerAfterTheFirst)
{
	ReflectShader(MakeShader().Request);
	ForgetCompiledShaders();
	const FNoCompilers None;
	EXPECT_EQ("Out", ReflectShader(MakeShader().Request).RWBuffers.at(0).Name);
}

TEST_F(FShaderCacheTest, WithoutCompilerANewShaderSaysWhatIsMissing)
{
	ReflectShader(MakeShader("8").Request);
	setenv("DRYDOCK_CXX", "/nonexistent", 1);
	const std::string Error = ErrorOf(
		[]
		{
			FShaderHarness Harness = MakeShader("8");
			RunShader(Harness);
		});
	unsetenv("DRYDOCK_CXX");
	EXPECT_THAT(Error, HasSubstr("no C++ compiler was found"));
}

TEST_F(FShaderCacheTest, EditedTextIsCompiledAgain)
{
	FShaderHarness First = MakeShader("3");
	FShaderHarness Second = MakeShader("4");
	EXPECT_EQ(3.0f, RunShader(First));
	bool bFromCache = true;
	EXPECT_EQ(4.0f, RunShader(Second, &bFromCache));
	EXPECT_FALSE(bFromCache);
}

TEST_F(FShaderCacheTest, DefinesAndLanesAreDifferentEntries)
{
	FShaderHarness Harness = MakeShader("VALUE");
	Harness.Request.Defines = {{"VALUE", "1"}};
	const std::string A = Harness.Run(4, 4, 1)->Key;
	Harness.Request.Defines = {{"VALUE", "2"}};
	const std::string B = Harness.Run(4, 4, 1)->Key;
	const std::string C = Harness.Run(2, 4, 1, 1, true)->Key;
	EXPECT_NE(A, B);
	EXPECT_NE(B, C);
}

TEST_F(FShaderCacheTest, DamagedKernelIsBuiltAgain)
{
	FShaderHarness Harness = MakeShader();
	RunShader(Harness);
	ForgetCompiledShaders();
	const std::vector<fs::path> Kernels = FilesWith(".so");
	ASSERT_EQ(1u, Kernels.size());
	fs::remove(Kernels[0]); // the loaded one keeps its memory
	std::ofstream(Kernels[0]) << "not a shared object";
	FShaderHarness Again = MakeShader();
	bool bFromCache = true;
	EXPECT_EQ(3.0f, RunShader(Again, &bFromCache));
	EXPECT_FALSE(bFromCache);
}

TEST_F(FShaderCacheTest, DamagedReflectionIsBuiltAgain)
{
	FShaderHarness Harness = MakeShader();
	RunShader(Harness);
	ForgetCompiledShaders();
	for (const fs::path& Json : FilesWith(".json"))
	{
		fs::resize_file(Json, fs::file_size(Json) / 2);
	}
	FShaderHarness Again = MakeShader();
	bool bFromCache = true;
	EXPECT_EQ(3.0f, RunShader(Again, &bFromCache));
	EXPECT_FALSE(bFromCache);
}

TEST_F(FShaderCacheTest, NothingIsLeftLyingAbout)
{
	FShaderHarness Harness = MakeShader();
	RunShader(Harness);
	EXPECT_TRUE(FilesWith(".tmp").empty());
}

TEST_F(FShaderCacheTest, FolderThatCannotBeWrittenIsNoError)
{
	setenv("DRYDOCK_CACHE_DIR", "/proc/nonexistent", 1);
	FShaderHarness Harness = MakeShader("5");
	EXPECT_EQ(5.0f, RunShader(Harness));
}

TEST_F(FShaderCacheTest, OneProcessBuildsTheOtherWaits)
{
	int Built = 0;
	std::vector<pid_t> Children;
	for (int i = 0; i < 3; ++i)
	{
		const pid_t Child = fork();
		ASSERT_GE(Child, 0);
		if (Child == 0)
		{
			bool bFromCache = false;
			FShaderHarness Harness = MakeShader("6");
			const bool bRight = RunShader(Harness, &bFromCache) == 6.0f;
			_exit(!bRight ? 2 : bFromCache ? 0 : 1);
		}
		Children.push_back(Child);
	}
	for (const pid_t Child : Children)
	{
		int Status = 0;
		ASSERT_EQ(Child, waitpid(Child, &Status, 0));
		ASSERT_TRUE(WIFEXITED(Status));
		ASSERT_NE(2, WEXITSTATUS(Status));
		Built += WEXITSTATUS(Status);
	}
	EXPECT_EQ(1, Built);
}

TEST_F(FShaderCacheTest, ThreadsShareOneCompilation)
{
	std::atomic<int> Built = 0;
	std::vector<std::thread> Threads;
	for (int i = 0; i < 4; ++i)
	{
		Threads.emplace_back(
			[&Built]
			{
				FShaderHarness Harness = MakeShader("7");
				Harness.Request.Lanes = {false, 4};
				static std::shared_ptr<const FCompiledShader> First = CompileShader(Harness.Request);
				Built += CompileShader(Harness.Request) == First ? 1 : 100;
			});
	}
	for (std::thread& Thread : Threads)
	{
		Thread.join();
	}
	EXPECT_EQ(4, Built);
}

TEST_F(FShaderCacheTest, LaneCountsThatDoNotExistAreAnError)
{
	EXPECT_THAT(ErrorOf([] { MakeShader().Run(5, 4, 1); }), HasSubstr("5 float lanes"));
	EXPECT_THAT(ErrorOf([] { MakeShader().Run(16, 4, 1, 1, true); }), HasSubstr("16 double lanes"));
}
