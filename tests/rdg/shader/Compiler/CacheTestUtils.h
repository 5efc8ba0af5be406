// What the tests of the shader cache share: a folder of their own, environment variables for a scope, small shaders.
#pragma once

#include "ShaderHarness.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <sys/stat.h>

namespace Drydock::Test
{

namespace fs = std::filesystem;

/** An environment variable for a scope; without a value it is unset. */
class FScopedVariable
{
public:
	FScopedVariable(const std::string& InName, const std::optional<std::string>& Value)
		: Name(InName)
	{
		if (const char* const Was = std::getenv(Name.c_str()))
		{
			Before = Was;
		}
		Set(Value);
	}
	~FScopedVariable() { Set(Before); }
	FScopedVariable(const FScopedVariable&) = delete;
	FScopedVariable& operator=(const FScopedVariable&) = delete;

private:
	void Set(const std::optional<std::string>& Value)
	{
		Value ? setenv(Name.c_str(), Value->c_str(), 1) : unsetenv(Name.c_str());
	}

	std::string Name;
	std::optional<std::string> Before;
};

/** A folder that goes with its scope. */
class FScratchFolder
{
public:
	FScratchFolder()
	{
		std::string Pattern = (fs::temp_directory_path() / "drydock_cache_test_XXXXXX").string();
		Path = mkdtemp(Pattern.data()) ? Pattern : "";
	}
	~FScratchFolder()
	{
		std::error_code Ignored;
		fs::remove_all(Path, Ignored);
	}
	FScratchFolder(const FScratchFolder&) = delete;
	FScratchFolder& operator=(const FScratchFolder&) = delete;

	std::string Add(const std::string& Name, const std::string& Text) const
	{
		const std::string File = (Path / Name).string();
		std::ofstream(File, std::ios::binary) << Text;
		return File;
	}
	/** A program that a shell runs. */
	std::string AddScript(const std::string& Name, const std::string& Text) const
	{
		const std::string File = Add(Name, "#!/bin/sh\n" + Text + "\n");
		fs::permissions(File, fs::perms::owner_all);
		return File;
	}

	fs::path Path;
};

inline std::string ReadBytes(const fs::path& File)
{
	std::ifstream Stream(File, std::ios::binary);
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

inline int GetMode(const fs::path& Path)
{
	struct stat Status;
	return lstat(Path.c_str(), &Status) == 0 ? int(Status.st_mode & 07777) : -1;
}

/** Every file below Folder, and Folder itself where it is none. */
inline std::vector<fs::path> ListFiles(const fs::path& Folder, const std::string& Extension = "")
{
	std::vector<fs::path> Files;
	std::error_code Missing;
	for (const fs::directory_entry& Entry : fs::recursive_directory_iterator(Folder, Missing))
	{
		if (!Entry.is_directory() && (Extension.empty() || Entry.path().extension() == Extension))
		{
			Files.push_back(Entry.path());
		}
	}
	return Files;
}

/** A shader that writes Value; Comment is part of its text. */
inline FShaderHarness MakeCacheShader(const std::string& Value, const std::string& Comment = "")
{
	FShaderHarness Harness(
		Comment +
			"\nRWStructuredBuffer<float> Out;\n[numthreads(8, 1, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n"
			"{\n\tOut[Id.x] = " +
			Value + ";\n}\n",
		"Main", EShaderStage::Compute);
	Harness.Buffers["Out"].assign(4, 0);
	return Harness;
}

struct FShaderRun
{
	float Value = 0.0f;
	bool bFromCache = false;
	int ExitCode = 0; // of the error, where there was one
	std::string Error;
	std::string Printed; // to stderr
};

/** Compiles the shader anew, or takes it from the cache on disk, and runs it. */
inline FShaderRun RunCacheShader(const std::string& Value, const std::string& Comment = "")
{
	FShaderRun Result;
	ForgetCompiledShaders();
	testing::internal::CaptureStderr();
	try
	{
		FShaderHarness Harness = MakeCacheShader(Value, Comment);
		Result.bFromCache = Harness.Run(4, 4, 1)->bFromCache;
		Result.Value = Harness.BufferFloat("Out", 2);
	}
	catch (const FError& Error)
	{
		Result.ExitCode = Error.GetExitCode();
		Result.Error = Error.what();
	}
	Result.Printed = testing::internal::GetCapturedStderr();
	ForgetCompiledShaders();
	return Result;
}

} // namespace Drydock::Test
