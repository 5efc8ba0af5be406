// The lane headers are precompiled once for all kernels of a compiler, and whatever becomes of that file costs time
// only.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CacheTestUtils.h"
#include "ShaderCache.h"

#include <algorithm>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;
using testing::Not;

class FPrecompiledHeadersTest : public testing::Test
{
protected:
	/** What g++ has said about headers since the last call: "! PATH" for one that it took precompiled. */
	std::string TakeLog() const
	{
		const std::string Text = ReadBytes(Log);
		fs::remove(Log);
		return Text;
	}
	size_t CountCompilerRuns() const
	{
		const std::string Text = ReadBytes(Runs);
		return size_t(std::count(Text.begin(), Text.end(), '\n'));
	}
	std::vector<fs::path> ListPrecompiled() const { return ListFiles(CacheFolder, ".gch"); }

	const FScratchFolder Scratch;
	const fs::path CacheFolder = Scratch.Path / "cache";
	const fs::path Log = Scratch.Path / "log";
	const fs::path Runs = Scratch.Path / "runs";
	const FScopedVariable Cache{"DRYDOCK_CACHE_DIR", CacheFolder.string()};
	const FScopedVariable Compiler{"DRYDOCK_CXX",
		Scratch.AddScript("compiler", "echo >>" + Runs.string() + "\nexec g++ -H \"$@\" 2>>" + Log.string())};
};

} // namespace

TEST_F(FPrecompiledHeadersTest, AreTakenFromTheSecondKernelOn)
{
	EXPECT_EQ(1.0f, RunCacheShader("1").Value);
	EXPECT_THAT(TakeLog(), Not(HasSubstr("! ")));
	EXPECT_EQ(1u, ListPrecompiled().size());
	EXPECT_EQ(2.0f, RunCacheShader("2").Value);
	EXPECT_THAT(TakeLog(), HasSubstr("! "));
	EXPECT_EQ(1u, ListPrecompiled().size());
}

TEST_F(FPrecompiledHeadersTest, AreMadeOnceAndEveryEditIsOneKernel)
{
	RunCacheShader("1");
	EXPECT_EQ(2u, CountCompilerRuns()); // the kernel, and the headers for those to come
	for (size_t Edit = 1; Edit <= 3; ++Edit)
	{
		RunCacheShader("1" + std::to_string(Edit));
		EXPECT_EQ(2 + Edit, CountCompilerRuns());
	}
}

TEST_F(FPrecompiledHeadersTest, ThatAreDamagedAreDoneWithout)
{
	RunCacheShader("1");
	ASSERT_EQ(1u, ListPrecompiled().size());
	const std::string Whole = ReadBytes(ListPrecompiled()[0]);
	int Value = 2;
	for (const std::string& Bytes : {std::string(), std::string("no headers"), Whole.substr(0, Whole.size() / 2)})
	{
		std::ofstream(ListPrecompiled()[0], std::ios::binary) << Bytes;
		const FShaderRun Run = RunCacheShader(std::to_string(Value));
		EXPECT_EQ(float(Value), Run.Value) << Bytes.size() << " bytes: " << Run.Error;
		++Value;
	}
}

TEST_F(FPrecompiledHeadersTest, ThatOthersCanWriteAreNotTaken)
{
	RunCacheShader("1");
	ASSERT_EQ(1u, ListPrecompiled().size());
	chmod(ListPrecompiled()[0].c_str(), 0666);
	TakeLog();
	EXPECT_EQ(2.0f, RunCacheShader("2").Value);
	EXPECT_THAT(TakeLog(), Not(HasSubstr("! ")));
}

TEST_F(FPrecompiledHeadersTest, DoNotGetIntoACacheThatIsFilledForOthers)
{
	FShaderCache::SetUse(EShaderCacheUse::Required);
	RunCacheShader("1");
	TakeLog();
	EXPECT_EQ(2.0f, RunCacheShader("2").Value);
	FShaderCache::SetUse(EShaderCacheUse::Usual);
	EXPECT_THAT(TakeLog(), HasSubstr("! ")); // this run's own
	EXPECT_TRUE(ListPrecompiled().empty());
}
