// `drydock matrix` from a plugin's folder to the table, and the mistakes that end it. One plugin is built for two
// versions for real.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Diagnostics.h"
#include "Matrix/Matrix.h"
#include "Matrix/MatrixErrors.h"
#include "Matrix/MatrixSummary.h"
#include "Text/OutputErrors.h"

#include <filesystem>
#include <fstream>
#include <unistd.h>

using namespace Drydock;

namespace
{

namespace Files = std::filesystem;

/** A plugin that compiles with a warning, and under 5.5 crashes. */
const char* const GPlugin = R"(#include "Modules/ModuleManager.h"
#include "Runtime/Launch/Resources/Version.h"
#include "SceneViewExtension.h"

[[deprecated("use New")]] inline void Old() {}

class FTintExtension : public FSceneViewExtensionBase
{
public:
	FTintExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}
	virtual void SetupView(FSceneViewFamily& InViewFamily, FSceneView& InView) override
	{
		Old();
#if !UE_VERSION_OLDER_THAN(5, 5, 0)
		*static_cast<volatile int*>(nullptr) = 1;
#endif
	}
};

class FTintModule : public IModuleInterface
{
public:
	virtual void StartupModule() override { Extension = FSceneViewExtensions::NewExtension<FTintExtension>(); }

private:
	TSharedPtr<FTintExtension, ESPMode::ThreadSafe> Extension;
};

IMPLEMENT_MODULE(FTintModule, Tint)
)";

class MatrixOfPlugin : public testing::Test
{
protected:
	MatrixOfPlugin()
		: Root(Files::temp_directory_path() / ("drydock_matrix_" + std::to_string(getpid())))
	{
		Files::remove_all(Root);
		Write("Tint/Tint.uplugin", "{}");
		Write("Tint/Source/Tint/Tint.Build.cs", "");
		Write("Tint/Source/Tint/Private/Tint.cpp", GPlugin);
	}
	~MatrixOfPlugin() override { Files::remove_all(Root); }

	void Write(const std::string& Path, const std::string& Text) const
	{
		Files::create_directories((Root / Path).parent_path());
		std::ofstream(Root / Path) << Text;
	}
	FMatrixRequest Describe() const
	{
		FMatrixRequest Request;
		Request.Folder = (Root / "Tint").string();
		Request.Minors = {4, 5};
		Request.OutputFolder = (Root / "out").string();
		Request.Program = DRYDOCK_TEST_BINARY_DIR "/bin/drydock";
		return Request;
	}
	static FDiagnostic Refuse(const FMatrixRequest& Request, EExitCode ExitCode)
	{
		try
		{
			RunMatrix(Request);
		}
		catch (const FError& Error)
		{
			EXPECT_EQ(ExitCode, Error.GetExitCode());
			return Error.GetDiagnostics().front();
		}
		return {};
	}
	std::string Read(const std::string& Path) const
	{
		std::ifstream Stream(Root / Path);
		return std::string(std::istreambuf_iterator<char>(Stream), {});
	}

	Files::path Root;
};

TEST_F(MatrixOfPlugin, ACrashUnderOneVersionIsACellOfIt)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
	GTEST_SKIP() << "the sanitizer takes the signal";
#endif
	FMatrixRequest Request = Describe();
	std::vector<std::pair<int, int>> Steps;
	Request.Progress = [&Steps](int Done, int Total, const std::string&)
	{
		Steps.emplace_back(Done, Total);
	};
	FVersionMatrix First = RunMatrix(Request);
	ASSERT_EQ(2u, First.Rows.size());
	for (const FMatrixRow& Row : First.Rows)
	{
		EXPECT_TRUE(Row.Build.bBuilt) << DescribeMessage(Row.Build.FirstError.value_or(FMatrixMessage()));
		ASSERT_EQ(1u, Row.Build.Warnings.size());
		EXPECT_EQ("Source/Tint/Private/Tint.cpp", Row.Build.Warnings[0].File);
		EXPECT_THAT(Row.Build.Warnings[0].Text, testing::HasSubstr("use New"));
	}
	EXPECT_TRUE(First.Rows[0].Succeeded());
	EXPECT_THAT(First.Rows[0].Run->Extensions, testing::Contains(testing::HasSubstr("FTintExtension")));
	EXPECT_FALSE(First.Rows[0].Run->Passes.empty());
	EXPECT_FALSE(First.Rows[0].Run->Passes.back().Written.empty());
	ASSERT_TRUE(First.Rows[1].Run);
	EXPECT_EQ(ExitPlugin, First.Rows[1].Run->ExitCode);
	EXPECT_THAT(DescribeEnd(*First.Rows[1].Run), testing::StartsWith("crashes: SetupView"));
	EXPECT_EQ(ExitUsage, GetMatrixExitCode(First));
	EXPECT_THAT(Read("out/matrix.txt"), testing::HasSubstr("crashes: SetupView"));
	EXPECT_TRUE(Files::exists(Root / "out/matrix.json"));
	EXPECT_TRUE(Files::exists(Root / "out/matrix.png"));
	EXPECT_FALSE(Files::exists(Root / "out/.drydock.lock"));
	ASSERT_FALSE(Steps.empty());
	EXPECT_EQ((std::pair<int, int>{4, 4}), Steps.back());

	// Nothing is compiled the second time, and what the compiler said still counts.
	const std::string Json = Read("out/matrix.json");
	RunMatrix(Request);
	EXPECT_EQ(Json, Read("out/matrix.json"));
}

TEST_F(MatrixOfPlugin, WhatIsNoPluginIsSaidBeforeAnythingIsWritten)
{
	FMatrixRequest Request = Describe();
	Request.Folder = (Root / "Nowhere").string();
	EXPECT_EQ(ErrorMatrixFolder, Refuse(Request, ExitUsage).Code);
	Write("Empty/readme.txt", "nothing here");
	Request.Folder = (Root / "Empty").string();
	EXPECT_EQ(ErrorMatrixFolder, Refuse(Request, ExitUsage).Code);
	EXPECT_FALSE(Files::exists(Root / "out"));
}

TEST_F(MatrixOfPlugin, ACompilerThatIsNotThereIsSaid)
{
	FMatrixRequest Request = Describe();
	Request.Compiler = "no-such-compiler";
	const FDiagnostic Said = Refuse(Request, ExitUsage);
	EXPECT_EQ(ErrorMatrixCompiler, Said.Code);
	EXPECT_THAT(Said.Message, testing::HasSubstr("no-such-compiler"));
	EXPECT_FALSE(Files::exists(Root / "out"));
}

TEST_F(MatrixOfPlugin, AConfigThatCannotBeReadIsSaidBeforeBuilding)
{
	FMatrixRequest Request = Describe();
	Request.Config = (Root / "nothing.json").string();
	Refuse(Request, ExitFiles);
	Write("broken.json", "{");
	Request.Config = (Root / "broken.json").string();
	EXPECT_EQ(1001, Refuse(Request, ExitUsage).Code);
	EXPECT_FALSE(Files::exists(Root / "out"));
}

TEST_F(MatrixOfPlugin, FilesOfOthersAreLeftAlone)
{
	Write("out/5.4/CMakeLists.txt", "mine\n");
	FMatrixRequest Request = Describe();
	Request.Minors = {4};
	EXPECT_EQ(ErrorForeignContent, Refuse(Request, ExitUsage).Code);
	EXPECT_EQ("mine\n", Read("out/5.4/CMakeLists.txt"));

	Write("out/matrix.txt", "mine\n");
	EXPECT_EQ(ErrorForeignContent, Refuse(Request, ExitUsage).Code);
	EXPECT_EQ("mine\n", Read("out/matrix.txt"));
}

TEST(MatrixPlan, ARunIsOfOneVersionAndOnePlugin)
{
	FVersionMatrix Matrix;
	Matrix.Config = "frame.json";
	Matrix.OutputFolder = "out";
	FMatrixRow Row;
	Row.Minor = 6;
	Row.Build.Library = "out/5.6/cmake/libTint.so";
	EXPECT_EQ((std::vector<std::string>{"drydock", "run", "frame.json", "--engine", "5.6", "--plugin",
				  "out/5.6/cmake/libTint.so", "--fingerprints", "--out", "out/5.6/run"}),
		MakeRunArguments("drydock", Matrix, Row));
}

} // namespace
