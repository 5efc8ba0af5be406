// A float curve as settings name it: an identity without keys. Source: engine Curves/CurveFloat.h; here an object
// stands for the asset's path (SettingObjects.h).
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

class DRYDOCK_API UCurveFloat : public UObject
{
};
