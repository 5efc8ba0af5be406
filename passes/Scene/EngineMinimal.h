// The engine's umbrella. Source: engine file EngineMinimal.h.
#pragma once

#include "CoreMinimal.h"
#include "Engine/Engine.h"
#include "Engine/Texture2D.h"
#include "GameFramework/Actor.h"
